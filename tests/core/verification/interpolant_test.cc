#include "core/verification/interpolant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace dualarm {
namespace {

/// The knot of a polynomial (coefficients of powers of time) at a time.
Knot knot_of(const std::array<double, 6>& c, double t) {
  Knot knot;
  knot.time = t;
  for (int n = 5; n >= 0; --n) knot.position = knot.position * t + c[n];
  for (int n = 5; n >= 1; --n) knot.velocity = knot.velocity * t + n * c[n];
  for (int n = 5; n >= 2; --n) knot.acceleration = knot.acceleration * t + n * (n - 1) * c[n];
  return knot;
}

TEST(Quintic, ReproducesEveryPolynomialOfDegreeFive) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    std::array<double, 6> c;
    for (double& value : c) value = number(generator);
    const Quintic piece(knot_of(c, 0.3), knot_of(c, 1.1));
    for (double t = 0.3; t <= 1.1; t += 0.05) {
      const Knot exact = knot_of(c, t);
      ASSERT_NEAR(piece.derivative(0, t), exact.position, 1e-12);
      ASSERT_NEAR(piece.derivative(1, t), exact.velocity, 1e-11);
      ASSERT_NEAR(piece.derivative(2, t), exact.acceleration, 1e-10);
    }
    ASSERT_NEAR(piece.derivative(5, 0.5), 120.0 * c[5], 1e-6);
  }
}

TEST(Quintic, KnowsAllDerivativesInItsMiddle) {
  const Quintic piece({3.0, 0.1, 0.2, 0.3, 0.0}, {3.8, 0.5, -0.4, 1.0, 0.0});
  const auto middle = piece.in_the_middle();
  for (int order = 0; order <= 5; ++order) {
    EXPECT_NEAR(middle[order], piece.derivative(order, 3.4), 1e-12 * (1.0 + piece.most(std::max(order, 1))));
  }
}

TEST(Quintic, BoundsAreAboveEveryDerivative) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  const auto any = [&] { return number(generator); };
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const double h = std::pow(10.0, any());
    const Quintic piece({0.0, any(), any(), any(), 0.0}, {h, any(), any(), any(), 0.0});
    for (int order = 1; order <= 5; ++order) {
      double largest = 0.0;
      for (int k = 0; k <= 200; ++k) largest = std::max(largest, std::abs(piece.derivative(order, h * k / 200)));
      ASSERT_LE(largest, piece.most(order) * (1.0 + 1e-9) + 1e-9);
    }
  }
}

TEST(Quintic, BoundsAreCloseOnShortPiecesOfSmoothMotions) {
  const std::array<double, 6> c = {0.3, -1.2, 0.8, 0.5, -0.4, 0.2};
  const Quintic piece(knot_of(c, 0.10), knot_of(c, 0.11));
  for (int order = 1; order <= 4; ++order) {
    const double largest = std::max(std::abs(piece.derivative(order, 0.10)), std::abs(piece.derivative(order, 0.11)));
    EXPECT_LE(piece.most(order), 1.001 * largest) << order;
  }
}

TEST(Quintic, RoundingOfItsEndsCoversWhatALastDigitDoes) {
  const Knot start = {1.0, 0.7, 1.3, 2.0, 0.0};
  for (const double h : {1e-6, 1e-4, 1e-2}) {
    Knot end = {1.0 + h, 0.0, 0.0, 2.0, 0.0};
    const double step = end.time - start.time;
    end.position = start.position + step * (start.velocity + step);
    end.velocity = start.velocity + 2.0 * step;
    const Quintic piece(start, end);
    for (double u = 0.0; u <= 1.0; u += 0.125) {
      const double t = 1.0 + u * step;
      EXPECT_LE(std::abs(piece.derivative(2, t) - 2.0), piece.acceleration_rounding() + 1e-13) << h;
      EXPECT_LE(std::abs(piece.derivative(1, t) - 1.3 - 2.0 * u * step), piece.velocity_rounding() + 1e-13) << h;
    }
  }
}

TEST(Quintic, NumbersThatOverflowAreBoundedByInfinity) {
  const Quintic piece({0.0, 1e300, 0.0, 0.0, 0.0}, {1e-9, -1e300, 1e300, 0.0, 0.0});
  EXPECT_TRUE(std::isinf(piece.most(5)));
}

TEST(Interpolant, BoundsOfLongMotionsAreThoseOfTheirPieces) {
  std::vector<Knot> knots;
  for (int k = 0; k <= 3000; ++k) knots.push_back({0.01 * k, std::sin(0.003 * k), 0.3 * std::cos(0.003 * k), 0.0, 0.0});
  const Interpolant motion(knots);
  for (const Interval time : {Interval{0.0, 30.0}, {0.005, 29.993}, {2.56, 5.12}, {2.555, 7.6801}, {29.0, 30.0}}) {
    SCOPED_TRACE(testing::Message() << time.lower << " to " << time.upper);
    double travel = 0.0;
    Interpolant::Bounds most;
    for (std::size_t i = 0; i < motion.piece_count(); ++i) {
      const Quintic piece = motion.piece(i);
      const double shared = std::min(piece.time().upper, time.upper) - std::max(piece.time().lower, time.lower);
      if (shared <= 0.0) continue;
      travel += shared * piece.most(1);
      most.speed = std::max(most.speed, piece.most(1));
      most.acceleration = std::max(most.acceleration, piece.most(2));
    }
    EXPECT_GE(motion.travel(time), travel - 1e-14);
    EXPECT_LE(motion.travel(time), travel + 1e-11);  // 3,000 roundings that it has to allow for
    EXPECT_NEAR(motion.bounds(time).speed, most.speed, 1e-4);
    EXPECT_GE(motion.bounds(time).speed, most.speed);
    EXPECT_GE(motion.bounds(time).acceleration, most.acceleration);
  }
}

/// To and fro, with knots that share a time, and with an odd and an even number of pieces.
TEST(Interpolant, RangesContainEveryPiece) {
  std::mt19937_64 generator(6);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  const auto any = [&] { return number(generator); };
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Knot> knots = {{0.3, any(), any(), any(), 0.0}};
    for (int k = 0; k < 3 + trial % 5; ++k) {
      const double time = knots.back().time + (any() > 1.0 ? 0.0 : std::pow(10.0, any()));
      knots.push_back({time, any(), any(), any(), 0.0});
    }
    const Interpolant motion(knots);
    for (std::size_t i = 0; i < motion.piece_count(); ++i) {
      const Quintic piece = motion.piece(i);
      EXPECT_EQ(motion.durations()[i], piece.duration());
      for (int k = 0; k <= 50; ++k) {
        const double time = piece.time().lower + piece.duration() * k / 50.0;
        const double position = piece.derivative(0, time);
        const double velocity = piece.derivative(1, time);
        const auto rounding = [](double size) { return 1e-12 * (1.0 + std::abs(size)); };
        for (const Interval& range : {motion.position_range(i), motion.position_range()}) {
          ASSERT_LE(position, range.upper + rounding(piece.most(1)));
          ASSERT_GE(position, range.lower - rounding(piece.most(1)));
        }
        for (const Interval& range : {motion.velocity_range(i), motion.velocity_range()}) {
          ASSERT_LE(velocity, range.upper + rounding(piece.most(2)));
          ASSERT_GE(velocity, range.lower - rounding(piece.most(2)));
        }
        ASSERT_LE(std::abs(velocity), motion.speeds()[i] + rounding(piece.most(2)));
        ASSERT_LE(std::abs(piece.derivative(2, time)), motion.most_accelerations()[i] + rounding(piece.most(3)));
        const JointState state = motion.state(time);
        if (k > 0 && k < 50) {
          ASSERT_NEAR(state.position, position, rounding(piece.most(1)));
          ASSERT_NEAR(state.velocity, velocity, rounding(piece.most(2)));
        }
      }
    }
  }
}

TEST(Interpolant, RangesOfMonotoneMotionsAreThoseOfTheirEnds) {
  const Interpolant motion(
      {{0.0, 0.0, 0.0, 1.0, 0.0}, {1.0, 0.5, 1.0, 1.0, 0.0}, {1.0, 0.5, 1.0, -1.0, 0.0}, {2.0, 1.0, 0.0, -1.0, 0.0}});
  EXPECT_EQ(motion.position_range(), (Interval{0.0, 1.0}));
  EXPECT_EQ(motion.velocity_range(), (Interval{0.0, 1.0}));
}

TEST(Interpolant, NumbersThatOverflowAreInfinite) {
  const Interpolant motion(
      {{0.0, 0.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0, 0.0}, {1.0 + 1e-9, -1e300, 1e300, 0.0, 0.0}});
  EXPECT_EQ(motion.position_range().lower, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.velocity_range().upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.speeds()[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.most_accelerations()[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.speeds()[0], 0.0);
  EXPECT_EQ(motion.travel({0.5, 2.0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.travel({0.0, 0.5}), 0.0);
}

TEST(Interpolant, OfAnIntervalTellsAllAtOnce) {
  std::vector<Knot> knots;
  for (int k = 0; k <= 200; ++k) knots.push_back({0.01 * k, std::sin(0.03 * k), 3.0 * std::cos(0.03 * k), 0.0, 0.0});
  const Interpolant motion(knots);
  for (const Interval time : {Interval{0.0, 2.0}, {0.305, 0.306}, {0.31, 1.2}, {-1.0, 0.5}, {1.5, 3.0}, {2.5, 3.0}}) {
    SCOPED_TRACE(testing::Message() << time.lower << " to " << time.upper);
    const Interpolant::During during = motion.during(time);
    const double middle = 0.5 * (time.lower + time.upper);
    EXPECT_EQ(during.in_the_middle, motion.state(middle));
    EXPECT_EQ(during.farthest, std::max(motion.travel({time.lower, middle}), motion.travel({middle, time.upper})));
    EXPECT_EQ(during.most.speed, motion.bounds(time).speed);
    EXPECT_EQ(during.most.acceleration, motion.bounds(time).acceleration);
    for (int k = 0; k <= 20; ++k) {
      const double at = time.lower + time.length() * k / 20.0;
      EXPECT_LE(std::abs(motion.state(at).position - during.in_the_middle.position), during.farthest + 1e-15);
    }
  }
}

TEST(Interpolant, HasTheStatesOfItsKnotsAndRestsOutside) {
  const Interpolant motion({{0.0, 0.1, 0.0, 1.0, 0.0}, {0.5, 0.3, 0.6, 0.0, 0.0}, {1.0, 0.5, 0.0, -1.0, 0.0}});
  EXPECT_EQ(motion.state(-1.0), (JointState{0.1, 0.0}));
  EXPECT_EQ(motion.state(0.0), (JointState{0.1, 0.0}));
  EXPECT_DOUBLE_EQ(motion.state(0.5).position, 0.3);
  EXPECT_DOUBLE_EQ(motion.state(0.5).velocity, 0.6);
  EXPECT_EQ(motion.state(1.0), (JointState{0.5, 0.0}));
  EXPECT_EQ(motion.state(9.0), (JointState{0.5, 0.0}));
}

TEST(Interpolant, KnotsAtOneTimeMakeNoPiece) {
  const Interpolant motion(
      {{0.0, 0.0, 0.0, 2.0, 0.0}, {1.0, 1.0, 2.0, 2.0, 0.0}, {1.0, 1.0, 2.0, -2.0, 0.0}, {2.0, 2.0, 0.0, -2.0, 0.0}});
  ASSERT_EQ(motion.piece_count(), 2u);
  EXPECT_NEAR(motion.state(0.5).position, 0.25, 1e-15);
  EXPECT_NEAR(motion.state(1.5).position, 1.75, 1e-15);
  EXPECT_NEAR(motion.bounds({0.0, 2.0}).acceleration, 2.0, 1e-14);
}

TEST(Interpolant, OneInstantIsAMotion) {
  const Interpolant motion({{0.0, 0.7, 0.0, 0.0, 0.0}, {0.0, 0.7, 0.0, 0.0, 0.0}});
  EXPECT_EQ(motion.state(0.0), (JointState{0.7, 0.0}));
  EXPECT_EQ(motion.travel({0.0, 0.0}), 0.0);
  EXPECT_EQ(motion.bounds({0.0, 0.0}).speed, 0.0);
}

TEST(Interpolant, TravelIsAtLeastTheWayToAndFro) {
  const Interpolant motion({{0.0, 0.0, 0.0, 0.0, 0.0}, {1.0, 1.0, 0.0, 0.0, 0.0}, {2.0, 0.0, 0.0, 0.0, 0.0}});
  EXPECT_GE(motion.travel({0.0, 2.0}), 2.0);
  EXPECT_GE(motion.travel({0.5, 1.5}), 1.0);
  EXPECT_LE(motion.travel({0.0, 2.0}), 10.0 + 1e-13);
}

}  // namespace
}  // namespace dualarm

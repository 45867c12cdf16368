#include "core/verification/separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

/// A body on a link that turns with a constant angular acceleration.
struct Turning {
  Base base;
  Capsule in_link;
  double position;
  double rate;
  double rate_change;

  Capsule at(double t) const {
    return placed(in_link, link_pose(base, position + t * rate + 0.5 * t * t * rate_change));
  }
  TurningBody body(double half_interval) const {
    return {at(0.0),
            base.position,
            reach(in_link),
            rate,
            std::abs(rate) + half_interval * std::abs(rate_change),
            std::abs(rate_change)};
  }
};

class RandomTurning {
 public:
  explicit RandomTurning(std::uint64_t seed) : generator_(seed) {}
  double between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(generator_); }
  Turning next(double x) {
    const double z = between(-0.5, 0.5);
    return {{{x, between(-1.0, 1.0), z}, 0.0, Rotation::kCounterclockwise},
            {{between(0.0, 1.0), between(-1.0, 1.0), 0.0},
             {between(1.0, 6.0), between(-1.0, 1.0), between(-1.0, 1.0)},
             between(0.0, 0.3)},
            between(-3.0, 3.0),
            between(-2.0, 2.0),
            between(-4.0, 4.0)};
  }

 private:
  std::mt19937_64 generator_;
};

double true_minimum(const Turning& first, const Turning& second, double half_interval) {
  double least = 1e300;
  for (int k = -100; k <= 100; ++k) {
    const double t = half_interval * k / 100;
    least = std::min(least, static_cast<double>(exact_distance(first.at(t), second.at(t))));
  }
  return least;
}

Eigen::Vector3d normal_of(const Turning& first, const Turning& second) {
  const Clearance found = clearance(first.at(0.0), second.at(0.0));
  return (found.point_on_first - found.point_on_second).normalized();
}

TEST(Separation, NeverClaimsMoreThanTheSmallestDistance) {
  RandomTurning random(5);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 5, pair " << i);
    const Turning first = random.next(0.0);
    const Turning second = random.next(8.0);
    const double half = std::pow(10.0, random.between(-4.0, -0.3));
    const double bound = separation_bound(first.body(half), second.body(half), normal_of(first, second), half);
    ASSERT_LE(bound, true_minimum(first, second, half) + 1e-12);
  }
}

TEST(Separation, HoldsForAnyNormal) {
  RandomTurning random(6);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 6, pair " << i);
    const Turning first = random.next(0.0);
    const Turning second = random.next(8.0);
    const Eigen::Vector3d normal =
        Eigen::Vector3d(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)).normalized();
    const double half = 0.05;
    ASSERT_LE(separation_bound(first.body(half), second.body(half), normal, half),
              true_minimum(first, second, half) + 1e-12);
  }
}

TEST(Separation, IsTheDistanceForAnInstant) {
  RandomTurning random(8);
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed 8, pair " << i);
    const Turning first = random.next(0.0);
    const Turning second = random.next(8.0);
    const auto distance = static_cast<double>(exact_distance(first.at(0.0), second.at(0.0)));
    if (distance < 1e-3) continue;
    ASSERT_NEAR(separation_bound(first.body(0.0), second.body(0.0), normal_of(first, second), 0.0), distance, 2e-7);
  }
}

TEST(Separation, LosesWithTheSquareOfTheIntervalWhereATipSlidesAlongALink) {
  // The first link turns after the tip of the second, which slides along it: the distance keeps still to first order.
  const Turning first = {{}, {{0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, 0.1}, 0.5, 1.0, 0.0};
  const Eigen::Vector3d along(std::cos(0.5), std::sin(0.5), 0.0);
  const Eigen::Vector3d across(-std::sin(0.5), std::cos(0.5), 0.0);
  const Eigen::Vector3d tip = 4.0 * along + 0.3 * across;
  const Base base = {tip + 5.0 * std::sqrt(0.5) * (along + across), 0.5 + 1.25 * std::numbers::pi,
                     Rotation::kCounterclockwise};
  const Turning second = {base, {{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, 0.1}, 0.0, -0.8 * std::sqrt(2.0), 0.0};
  const Eigen::Vector3d normal = normal_of(first, second);
  const auto loss = [&](double half) {
    return true_minimum(first, second, half) - separation_bound(first.body(half), second.body(half), normal, half);
  };
  EXPECT_LT(loss(1e-2), 20.0 * 1e-4);
  EXPECT_LT(loss(1e-3), 20.0 * 1e-6);
}

}  // namespace
}  // namespace dualarm

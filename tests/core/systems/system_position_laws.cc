#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "tests/core/systems/system_laws.h"
#include "tests/core/systems/system_samples.h"

namespace dualarm {
namespace {

// The laws of what a System says about a whole stretch of positions: work, zeros, bends, stiffness.

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rounding of a quadrature's end `from + change`, rad: twice that of 16 rad.
constexpr double kPositionRounding = 4e-15;
/// Curvature of accelerations between bends, of the scale per rad2 or (rad/s)2: gravity's is below.
constexpr double kCurvature = 2.0;

bool straddles(const std::vector<double>& bends, double from, double to) {
  return std::any_of(bends.begin(), bends.end(), [=](double bend) { return from < bend && bend < to; });
}

std::vector<double> pieces_between(const std::vector<double>& bends, double from, double to) {
  std::vector<double> ends = {std::min(from, to)};
  std::copy_if(bends.begin(), bends.end(), std::back_inserter(ends),
               [=](double bend) { return std::min(from, to) < bend && bend < std::max(from, to); });
  ends.push_back(std::max(from, to));
  return ends;
}

}  // namespace

TEST_P(SystemLaws, WorkIsTheIntegralOfTheAccelerationAtStandstill) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const std::vector<double> bends = system.position_bends({-kInfinity, kInfinity});
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    for (const Extreme extreme : kExtremes) {
      const auto along = [&](double s) { return system.extreme_acceleration(extreme, s, 0.0); };
      for (const double from : samples.everywhere) {
        for (const double change : {-3.1, -0.7, -1e-3, 1e-6, 0.4, 2.6}) {
          const double to = from + change;
          double expected = 0.0;
          const std::vector<double> ends = pieces_between(bends, from, to);
          for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            expected += Quadrature::integrate(along, ends[i], ends[i + 1], 0);
          }
          const double rounding = kPositionRounding + 1e-11 * std::abs(change);
          ASSERT_NEAR(system.specific_work(extreme, from, change), std::copysign(1.0, change) * expected,
                      samples.scale * rounding)
              << from << ", " << change;
        }
      }
    }
  });
}

TEST_P(SystemLaws, SmallWorkKeepsItsDigits) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const std::vector<double> bends = system.position_bends({-kInfinity, kInfinity});
    for (const Extreme extreme : kExtremes) {
      for (const double from : samples.everywhere) {
        for (const double change : {-1e-5, -1e-9, 1e-13, 1e-7}) {
          if (straddles(bends, std::min(from, from + change), std::max(from, from + change))) continue;
          const double middle = system.extreme_acceleration(extreme, from + 0.5 * change, 0.0);
          ASSERT_NEAR(system.specific_work(extreme, from, change) / change, middle, 1e-11 * samples.scale)
              << from << ", " << change;
        }
      }
    }
  });
}

TEST_P(SystemLaws, ZerosAreAllSignChangesAndNothingElse) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const Interval range = system.range();
    for (const Extreme extreme : kExtremes) {
      for (const double s_dot : samples.velocities) {
        SCOPED_TRACE(s_dot);
        const auto along = [&](double s) { return system.extreme_acceleration(extreme, s, s_dot); };
        std::vector<double> cuts = system.zeros(extreme, s_dot, range);
        for (const double zero : cuts) ASSERT_NEAR(along(zero), 0.0, kAccelerationRounding * samples.scale);
        cuts.insert(cuts.begin(), range.lower);
        cuts.push_back(range.upper);
        double sign_before = 0.0;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
          ASSERT_LE(cuts[i], cuts[i + 1]);
          if (cuts[i] == cuts[i + 1]) {
            ASSERT_TRUE(i == 0 || i + 2 == cuts.size()) << "twice: " << cuts[i];
            continue;
          }
          const double sign = along(0.5 * (cuts[i] + cuts[i + 1]));
          ASSERT_LE(sign * sign_before, 0.0) << "no sign change at " << cuts[i];
          sign_before = sign;
          for (const double s : samples.positions) {
            if (s <= cuts[i] || s >= cuts[i + 1] || std::abs(along(s)) < kAccelerationRounding * samples.scale)
              continue;
            ASSERT_GT(along(s) * sign, 0.0) << "missed near " << s;
          }
        }
      }
    }
  });
}

TEST_P(SystemLaws, ZerosOfAPartAreThoseOfTheWhole) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const Interval range = system.range();
    const Interval part = {range.lower + 0.31 * range.length(), range.lower + 0.77 * range.length()};
    for (const Extreme extreme : kExtremes) {
      for (const double s_dot : samples.velocities) {
        std::vector<double> expected = system.zeros(extreme, s_dot, range);
        std::erase_if(expected, [&](double s) { return !part.contains(s); });
        const std::vector<double> zeros = system.zeros(extreme, s_dot, part);
        ASSERT_EQ(zeros.size(), expected.size());
        for (std::size_t i = 0; i < zeros.size(); ++i) ASSERT_NEAR(zeros[i], expected[i], 1e-9);  // rad, flat zeros
      }
    }
  });
}

TEST_P(SystemLaws, AccelerationsAreSmoothBetweenBends) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const auto expect_smooth = [&](const auto& along, const std::vector<double>& bends, Interval over) {
      constexpr int kSteps = 800;
      const double h = over.length() / kSteps;
      for (int i = 1; i < kSteps; ++i) {
        const double x = over.lower + h * i;
        if (straddles(bends, x - h, x + h)) continue;
        const double bow = along(x - h) - 2.0 * along(x) + along(x + h);
        ASSERT_LT(std::abs(bow), samples.scale * (kCurvature * h * h + kAccelerationRounding)) << x;
      }
    };
    const std::vector<double> position_bends = system.position_bends({-kInfinity, kInfinity});
    std::vector<double> velocity_bends = system.velocity_bends();
    EXPECT_TRUE(std::is_sorted(position_bends.begin(), position_bends.end()));
    EXPECT_TRUE(std::is_sorted(velocity_bends.begin(), velocity_bends.end()));
    velocity_bends.push_back(0.0);
    for (const Extreme extreme : kExtremes) {
      for (const double s_dot : samples.velocities) {
        expect_smooth([&](double s) { return system.extreme_acceleration(extreme, s, s_dot); }, position_bends,
                      {samples.everywhere.front(), samples.everywhere.back()});
      }
      for (std::size_t i = 0; i < samples.everywhere.size(); i += 20) {
        const double s = samples.everywhere[i];
        expect_smooth([&](double s_dot) { return system.extreme_acceleration(extreme, s, s_dot); }, velocity_bends,
                      {samples.velocities.front(), samples.velocities.back()});
      }
    }
  });
}

TEST_P(SystemLaws, BendsAreThoseInside) {
  hold_all_to([](const System& system) {
    const Interval range = system.range();
    std::vector<double> expected = system.position_bends({-kInfinity, kInfinity});
    std::erase_if(expected, [&](double s) { return !range.contains(s); });
    EXPECT_EQ(system.position_bends(range), expected);
  });
}

TEST_P(SystemLaws, AccelerationsFallNoSteeperThanTheStiffness) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    ASSERT_TRUE(std::isfinite(system.stiffness()));
    ASSERT_GE(system.stiffness(), 0.0);
    for (const Extreme extreme : kExtremes) {
      for (std::size_t i = 0; i + 1 < samples.everywhere.size(); ++i) {
        const double from = samples.everywhere[i];
        const double to = samples.everywhere[i + 1];
        const double fall =
            system.extreme_acceleration(extreme, from, 0.0) - system.extreme_acceleration(extreme, to, 0.0);
        ASSERT_LE(fall, system.stiffness() * (to - from) + kAccelerationRounding * samples.scale) << from;
      }
    }
  });
}

}  // namespace dualarm

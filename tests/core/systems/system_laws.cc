#include "tests/core/systems/system_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/systems/system_samples.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kDirections = {-1.0, 1.0};

/// By how much (of the scale) an acceleration may change over kTinyStep.
constexpr double kTinyChange = 1e-6;
/// By how much of the scale bounds may exceed what samples show.
constexpr double kLooseness = 1e-3;

}  // namespace

TEST_P(SystemLaws, AdmissibleAccelerationsAreIntervalsWithAnInside) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    for (const double s : samples.everywhere) {
      for (const double s_dot : samples.velocities) {
        const Interval admissible = system.acceleration(s, s_dot);
        ASSERT_LT(admissible.lower, admissible.upper) << s << ", " << s_dot;
      }
    }
  });
}

TEST_P(SystemLaws, AccelerationsAreContinuousInPositionAndVelocity) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    for (const double s : samples.everywhere) {
      for (const double s_dot : samples.velocities) {
        for (const Extreme extreme : kExtremes) {
          const double here = system.extreme_acceleration(extreme, s, s_dot);
          for (const double step : {-kTinyStep, kTinyStep}) {
            const double room = kTinyChange * samples.scale;
            ASSERT_NEAR(system.extreme_acceleration(extreme, s + step, s_dot), here, room) << s << ", " << s_dot;
            ASSERT_NEAR(system.extreme_acceleration(extreme, s, s_dot + step), here, room) << s << ", " << s_dot;
          }
        }
      }
    }
  });
}

TEST_P(SystemLaws, BoundsHoldEverywhereAndAreReached) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    const Interval bounds = system.acceleration_bounds();
    // Without a velocity limit: a velocity at which nothing but friction matters.
    constexpr double kFast = 1e9;
    std::vector<double> velocities = {std::max(-kFast, system.velocity().lower),
                                      std::min(kFast, system.velocity().upper)};
    std::copy_if(samples.velocities.begin(), samples.velocities.end(), std::back_inserter(velocities),
                 [&](double s_dot) { return system.velocity().contains(s_dot); });
    Interval seen = {kInfinity, -kInfinity};
    for (const double s : samples.positions) {
      for (const double s_dot : velocities) {
        const Interval admissible = system.acceleration(s, s_dot);
        seen = {std::min(seen.lower, admissible.lower), std::max(seen.upper, admissible.upper)};
      }
    }
    const double rounding = kAccelerationRounding * samples.scale;
    EXPECT_LE(bounds.lower, seen.lower + rounding);
    EXPECT_GE(bounds.upper, seen.upper - rounding);
    const double endless = 1e6 * samples.scale;
    const double finite = std::max(samples.scale, std::isfinite(bounds.length()) ? bounds.length() : 0.0);
    EXPECT_GT(std::max(bounds.lower, -endless), seen.lower - kLooseness * finite);
    EXPECT_LT(std::min(bounds.upper, endless), seen.upper + kLooseness * finite);
  });
}

TEST_P(SystemLaws, VelocityLimitsAllowBothDirections) {
  hold_all_to([](const System& system) {
    EXPECT_LT(system.velocity().lower, 0.0);
    EXPECT_GT(system.velocity().upper, 0.0);
  });
}

TEST_P(SystemLaws, VelocityMattersWhereItIsSaidTo) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    for (const Extreme extreme : kExtremes) {
      for (const double direction : kDirections) {
        double largest = 0.0;
        for (const double s : samples.everywhere) {
          const double at_rest = system.extreme_acceleration(extreme, s, 0.0);
          for (const double s_dot : samples.velocities) {
            if (s_dot * direction <= 0.0) continue;
            largest = std::max(largest, std::abs(system.extreme_acceleration(extreme, s, s_dot) - at_rest));
          }
        }
        EXPECT_EQ(system.velocity_matters(extreme, direction), largest > kAccelerationRounding * samples.scale)
            << static_cast<int>(extreme) << ", " << direction << ", " << largest;
      }
    }
  });
}

TEST_P(SystemLaws, StandstillIsBestForDrivingWhereItIsSaidToBe) {
  hold_all_to([](const System& system) {
    const SystemSamples samples(system);
    for (const double direction : kDirections) {
      const Extreme extreme = direction > 0.0 ? Extreme::kHighest : Extreme::kLowest;
      double most_gained = 0.0;
      for (const double s : samples.everywhere) {
        const double at_rest = system.extreme_acceleration(extreme, s, 0.0);
        for (const double s_dot : samples.velocities) {
          if (s_dot * direction <= 0.0) continue;
          const double moving = system.extreme_acceleration(extreme, s, s_dot);
          most_gained = std::max(most_gained, direction * (moving - at_rest));
        }
      }
      EXPECT_EQ(system.drives_best_at_rest(direction), most_gained <= kAccelerationRounding * samples.scale)
          << direction << ", " << most_gained;
    }
  });
}
}  // namespace dualarm

#include "tests/core/systems/playback_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/systems/playback.h"

namespace dualarm {
namespace {

/// Of the distance between the ends of the admissible accelerations, by which the quintic may break them.
constexpr double kExcess = 1e-9;
/// Position (rad) and velocity (rad/s) of the quintic against the exact motion.
constexpr double kDeparture = 1e-9;
/// Rounding of positions, rad: it shows divided by the spacing in velocities, by its square in accelerations.
constexpr double kRounding = 1e-14;

struct Instant {
  JointState state;
  double acceleration;
};

/// The quintic between two knots at a share of the time between them.
Instant between(const Knot& from, const Knot& to, double share) {
  const double h = to.time - from.time;
  const double t = share * h;
  const double travel = to.position - from.position - from.velocity * h - 0.5 * from.acceleration * h * h;
  const double gain = to.velocity - from.velocity - from.acceleration * h;
  const double jerk = to.acceleration - from.acceleration;
  const double c3 = (10.0 * travel - 4.0 * gain * h + 0.5 * jerk * h * h) / (h * h * h);
  const double c4 = (-15.0 * travel + 7.0 * gain * h - jerk * h * h) / (h * h * h * h);
  const double c5 = (6.0 * travel - 3.0 * gain * h + 0.5 * jerk * h * h) / (h * h * h * h * h);
  return {{from.position + t * (from.velocity + t * (0.5 * from.acceleration + t * (c3 + t * (c4 + t * c5)))),
           from.velocity + t * (from.acceleration + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)))},
          from.acceleration + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5))};
}

}  // namespace

void expect_faithful(const Arm& arm, const SingleJointArm& system, const Profile& profile, double period) {
  const double duration = profile.duration();
  const ArmTrajectory played = play(arm, system, {{0.0, profile}}, duration, period);
  EXPECT_EQ(played.knots.front().time, 0.0);
  EXPECT_EQ(played.knots.back().time, duration);
  for (const Arc& arc : profile.arcs()) {
    EXPECT_TRUE(std::any_of(played.knots.begin(), played.knots.end(), [&](const Knot& knot) {
      return std::abs(knot.time - arc.end_time) <= 1e-12 * duration && knot.position == arc.end.position;
    })) << arc.end_time;
  }
  constexpr double kUsualPeriod = 0.01;  // s, at which quintics are faithful but where arms nearly stall
  EXPECT_LT(played.knots.size(), 4.0 * (duration / kUsualPeriod + 4.0 * static_cast<double>(profile.arcs().size())));
  for (std::size_t i = 0; i + 1 < played.knots.size(); ++i) {
    const Knot& from = played.knots[i];
    const Knot& to = played.knots[i + 1];
    const double h = to.time - from.time;
    if (h == 0.0) continue;
    for (const double share : {0.2, 0.5, 0.7}) {
      const Instant here = between(from, to, share);
      const JointState exact = profile.at(from.time + share * h);
      const Interval limits = system.acceleration(here.state.position, here.state.velocity);
      const double rounding = kRounding * (1.0 + std::abs(exact.position));
      const double room = kExcess * limits.length() + rounding / (h * h);
      ASSERT_NEAR(here.state.position, exact.position, kDeparture) << from.time;
      ASSERT_NEAR(here.state.velocity, exact.velocity, kDeparture + rounding / h) << from.time;
      ASSERT_GE(here.acceleration, limits.lower - room) << from.time << ", " << share;
      ASSERT_LE(here.acceleration, limits.upper + room)
          << from.time << ", " << share << ": " << here.acceleration - limits.upper << " above, " << room << " allowed";
    }
  }
}

}  // namespace dualarm

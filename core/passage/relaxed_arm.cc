#include "core/passage/relaxed_arm.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/phase_plane/minimum.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Torque beyond gravity's, as a part of it, that makes a drive strong.
constexpr double kStrongBy = 1e-3;
/// Part by which a strict inequality of a proof has to hold beyond rounding.
constexpr double kProofMargin = 1e-9;
/// Part of the joint range to which the farthest turn is sought; what is left is added.
constexpr double kTurnTolerance = 1e-9;
constexpr std::uintmax_t kMostSteps = 60;

/// The farthest position from `from` towards the end of the range `to` at which the arm can turn back in time.
double farthest_turn(const Relaxation& relaxation, const Task& task, double from, double to, double duration) {
  const auto lateness = [&](double position) {
    const JointState turn = {position, 0.0};
    return relaxation.duration(task.start, turn) + relaxation.duration(turn, task.goal) - duration;
  };
  const double at_end = lateness(to);
  if (at_end <= 0.0) return to;
  const double at_start = lateness(from);
  if (at_start >= 0.0) return from;
  const double width = kTurnTolerance * std::abs(to - from);
  const bool is_up = to > from;
  std::uintmax_t steps = kMostSteps;
  const auto [low, high] = boost::math::tools::toms748_solve(
      lateness, std::min(from, to), std::max(from, to), is_up ? at_start : at_end, is_up ? at_end : at_start,
      [width](double a, double b) { return b - a <= width; }, steps);
  return is_up ? high : low;
}

/// Largest of sin(angle) over an interval.
double largest_sine(Interval angles) {
  const double crest = 0.5 * std::numbers::pi;
  const double turn = 2.0 * std::numbers::pi;
  const double next = crest + turn * std::ceil((angles.lower - crest) / turn);
  return next <= angles.upper ? 1.0 : std::max(std::sin(angles.lower), std::sin(angles.upper));
}

/// Largest of amplitude * sin(angle + shift) over an interval.
double largest_wave(double amplitude, Interval angles, double shift) {
  const double turned = amplitude < 0.0 ? shift + std::numbers::pi : shift;
  return std::abs(amplitude) * largest_sine({angles.lower + turned, angles.upper + turned});
}

}  // namespace

Interval reachable(const Arm& arm, const Task& task, double duration) {
  // A moving arm may get farther sooner than it can turn back near by: then nothing is left out.
  if (task.start.velocity != 0.0 || task.goal.velocity != 0.0) return arm.joint_range;
  const SingleJointArm system(arm);
  const Relaxation relaxation(system, task.start, task.goal);
  const auto [low, high] = std::minmax({task.start.position, task.goal.position});
  return {farthest_turn(relaxation, task, low, arm.joint_range.lower, duration),
          farthest_turn(relaxation, task, high, arm.joint_range.upper, duration)};
}

double complete_until(const Arm& arm) {
  const SingleJointArm system(arm);
  if (depends_on_velocity(system) || !is_strong(system)) return 0.0;
  // Beyond the range the accelerations may be continued as constants: only gravity's slope inside of it counts.
  const double amplitude = arm.gravity.amplitude;
  const double of_gravity = largest_wave(amplitude, arm.joint_range, 0.5 * std::numbers::pi - arm.gravity.phase);
  const double stiffness = system.stiffness() + (std::max(0.0, of_gravity) - std::abs(amplitude)) / arm.inertia;
  return stiffness > 0.0 ? std::numbers::pi * (1.0 - kProofMargin) / std::sqrt(stiffness) : kInfinity;
}

std::optional<Arm> relaxed_arm(const Arm& arm, const Task& task, double duration) {
  Arm relaxed = arm;
  relaxed.joint_range = reachable(arm, task, duration);
  if (complete_until(relaxed) > 0.0) return relaxed;
  Interval torque = torque_bounds(arm.torque);
  if (arm.viscous_friction > 0.0) {
    torque.lower -= arm.viscous_friction * arm.velocity.upper;
    torque.upper -= arm.viscous_friction * arm.velocity.lower;
  }
  if (!std::isfinite(torque.length())) return std::nullopt;
  const double amplitude = arm.gravity.amplitude;
  const double lifted = largest_wave(amplitude, relaxed.joint_range, -arm.gravity.phase);
  const double lowered = largest_wave(-amplitude, relaxed.joint_range, -arm.gravity.phase);
  const double more = kStrongBy * std::abs(amplitude);
  relaxed.viscous_friction = 0.0;
  relaxed.torque = Interval{std::min(torque.lower, -lowered - more), std::max(torque.upper, lifted + more)};
  return relaxed;
}

}  // namespace dualarm

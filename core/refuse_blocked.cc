#include "core/refuse_blocked.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/phase_plane/trace.h"
#include "core/wording.h"

namespace dualarm {
namespace {

InfeasibleReason reason_of(BlockReason reason) {
  switch (reason) {
    case BlockReason::kStartOutsideRange:
      return InfeasibleReason::kStartOutsideRange;
    case BlockReason::kGoalOutsideRange:
      return InfeasibleReason::kGoalOutsideRange;
    case BlockReason::kStartNotHoldable:
      return InfeasibleReason::kStartNotHoldable;
    case BlockReason::kGoalNotHoldable:
      return InfeasibleReason::kGoalNotHoldable;
    case BlockReason::kStartTooFast:
      return InfeasibleReason::kStartTooFast;
    case BlockReason::kGoalTooFast:
      return InfeasibleReason::kGoalTooFast;
    case BlockReason::kVelocityLimit:
      return InfeasibleReason::kVelocityLimit;
    case BlockReason::kStalls:
    case BlockReason::kCannotBrake:
      return InfeasibleReason::kTorqueTooSmall;
  }
  throw std::logic_error("unknown block reason");
}

std::string place(double position) { return worded(position, " rad (", degrees(position), " deg)"); }

Infeasible outside_range(const Arm& arm, const Blocked& blocked) {
  const double excess = std::max(arm.joint_range.lower - blocked.position, blocked.position - arm.joint_range.upper);
  const char* which = blocked.reason == BlockReason::kStartOutsideRange ? "start" : "goal";
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  evidence.relaxation = excess;
  return {reason_of(blocked.reason),
          worded("The ", which, " of ", arm.name, ", ", place(blocked.position), ", lies outside its joint range [",
                 arm.joint_range.lower, ", ", arm.joint_range.upper, "] rad by ", excess,
                 " rad; move it or widen the range."),
          evidence};
}

/// A start or goal whose velocity breaks its limit.
Infeasible beyond_velocity_limit(const Arm& arm, const JointState& state, BlockReason reason) {
  const double excess = std::max(arm.velocity.lower - state.velocity, state.velocity - arm.velocity.upper);
  const bool at_start = reason == BlockReason::kStartTooFast;
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = state.position;
  evidence.velocity = state.velocity;
  evidence.relaxation = excess;
  return {reason_of(reason),
          worded(arm.name, at_start ? " starts with " : " has to arrive with ", state.velocity, " rad/s at ",
                 place(state.position), ", ", excess, " rad/s beyond its velocity limits [", arm.velocity.lower, ", ",
                 arm.velocity.upper, "] rad/s; ", at_start ? "start" : "arrive", " slower or give a larger limit."),
          evidence};
}

/// The end of the free range that a start runs into, or that a goal has to be run up to from.
struct Wall {
  double position;
  std::string object;  ///< empty where it is the joint range's own end
  std::string body;    ///< what would meet the object
};

Wall wall_of(const FreeRange& free, const JointState& state, bool at_start) {
  const bool is_above = (state.velocity > 0.0) == at_start;
  return is_above ? Wall{free.range.upper, free.above, free.above_by}
                  : Wall{free.range.lower, free.below, free.below_by};
}

/// How much more range (rad) a start needs to be braked in, or a goal to be reached, if one turn is enough.
std::optional<double> missing_room(const SingleJointArm& system, const Blocked& blocked, bool at_start) {
  const double onwards = (blocked.velocity > 0.0) == at_start ? 1.0 : -1.0;
  const Trace beyond(system, blocked.extreme, {blocked.position, blocked.velocity}, at_start ? 1.0 : -1.0,
                     blocked.position + onwards * 2.0 * std::numbers::pi, std::numeric_limits<double>::infinity());
  if (beyond.stop() != Trace::Stop::kRest) return std::nullopt;
  return std::abs(beyond.end().state.position - blocked.position);
}

/// Whether starting or arriving slower would do: not where gravity has the better of the drive even at rest.
bool slower_helps(const SingleJointArm& system, const JointState& state, const Blocked& blocked, bool at_start) {
  if (blocked.position == state.position) return true;
  const double driven = system.extreme_acceleration(blocked.extreme, state.position, 0.0);
  return (driven * state.velocity < 0.0) == at_start;
}

std::string story(const JointState& state, const Wall& wall, const Blocked& blocked, bool at_start) {
  const std::string end = wall.object.empty()
                              ? worded("the end of its joint range, ", wall.position, " rad")
                              : worded(wall.position, " rad, where ", wall.object, " stands in its way");
  const std::string where = blocked.position == wall.position ? end : worded(blocked.position, " rad");
  if (state.position == wall.position) return worded(at_start ? ", and leaves " : ", and comes from beyond ", end);
  if (blocked.position == state.position) {
    return at_start ? "; that is too fast to stop before its goal, and once past it cannot come back"
                    : "; it has neither the room nor the torque to get as fast as that on its way there";
  }
  return at_start ? worded("; braking with full torque it is still at ", blocked.velocity, " rad/s at ", where)
                  : worded("; even with full torque all the way it would have to pass ", where, ", at ",
                           blocked.velocity, " rad/s already");
}

/// A start too fast to be braked, or a goal too fast to be reached, inside the free range.
Infeasible out_of_room(const Arm& arm, const JointState& state, const SingleJointArm& system, const FreeRange& free,
                       const Blocked& blocked) {
  const bool at_start = blocked.reason == BlockReason::kStartTooFast;
  const Wall wall = wall_of(free, state, at_start);
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  evidence.velocity = blocked.velocity;
  std::string remedy =
      wall.object.empty() ? "give a larger range or more torque." : "give more torque or move the object.";
  if (blocked.position == wall.position) {
    evidence.first_body = wall.body;
    evidence.second_body = wall.object;
    evidence.relaxation = missing_room(system, blocked, at_start);
    if (evidence.relaxation) remedy = worded("give ", *evidence.relaxation, " rad more room, or more torque.");
  }
  return {reason_of(blocked.reason),
          worded(arm.name, at_start ? " starts with " : " has to arrive with ", state.velocity, " rad/s at ",
                 place(state.position), story(state, wall, blocked, at_start), "; ",
                 !slower_helps(system, state, blocked, at_start) ? ""
                 : at_start                                      ? "start slower, or "
                                                                 : "arrive slower, or ",
                 remedy),
          evidence};
}

std::string what_fails(BlockReason reason) {
  switch (reason) {
    case BlockReason::kStartNotHoldable:
      return "cannot be held at its start";
    case BlockReason::kGoalNotHoldable:
      return "cannot be held at its goal";
    case BlockReason::kStalls:
      return "stalls on the way even with full torque";
    case BlockReason::kCannotBrake:
      return "cannot be braked to its goal, not even with full torque";
    case BlockReason::kVelocityLimit:
      return "cannot keep its velocity limit, not even braking with full torque";
    default:
      throw std::logic_error("not a matter of torque");
  }
}

/// Where the torque falls short of what keeps the velocity.
Infeasible too_weak(const Arm& arm, const SingleJointArm& system, const Blocked& blocked) {
  const Interval limits = torque_limits(arm.torque, blocked.position, blocked.velocity);
  const double needed = system.torque({blocked.position, blocked.velocity}, 0.0);
  const double available = blocked.extreme == Extreme::kLowest ? limits.lower : limits.upper;
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  if (blocked.velocity != 0.0) evidence.velocity = blocked.velocity;
  evidence.available_torque = available;
  // A state can be missed although the torque keeps the arm in it: there was too little room to get there.
  if (!(blocked.extreme == Extreme::kLowest ? needed <= available : needed >= available)) {
    return {reason_of(blocked.reason),
            worded(arm.name, " ", what_fails(blocked.reason), ": it would have to be at ", place(blocked.position),
                   " with ", blocked.velocity, " rad/s, and full torque, ", available,
                   " N m there, does not do it on the way; give the drive more torque, or start slower."),
            evidence};
  }
  evidence.needed_torque = needed;
  evidence.relaxation = std::abs(needed - available);
  const std::string state = blocked.velocity == 0.0
                                ? "gravity needs "
                                : worded("with ", blocked.velocity, " rad/s, keeping that velocity needs ");
  const bool gives_too_much = blocked.extreme == Extreme::kLowest ? available > 0.0 : available < 0.0;
  const std::string shortfall =
      gives_too_much
          ? worded(" N m, and the drive gives no ", available > 0.0 ? "less" : "more", " than ", available,
                   " N m; let its torque limits reach ", needed, " N m.")
          : worded(" N m and ", available, " N m are available; give the drive more torque or the arm ",
                   blocked.reason == BlockReason::kVelocityLimit ? "a larger velocity limit." : "less load.");
  return {reason_of(blocked.reason),
          worded(arm.name, " ", what_fails(blocked.reason), ": at ", place(blocked.position), " ", state, needed,
                 shortfall),
          evidence};
}

}  // namespace

Infeasible refuse_blocked(const Arm& arm, const Task& task, const SingleJointArm& system, const FreeRange& free,
                          const Blocked& blocked) {
  switch (blocked.reason) {
    case BlockReason::kStartOutsideRange:
    case BlockReason::kGoalOutsideRange:
      return outside_range(arm, blocked);
    case BlockReason::kStartTooFast:
    case BlockReason::kGoalTooFast: {
      const JointState& state = blocked.reason == BlockReason::kStartTooFast ? task.start : task.goal;
      return arm.velocity.contains(state.velocity) ? out_of_room(arm, state, system, free, blocked)
                                                   : beyond_velocity_limit(arm, state, blocked.reason);
    }
    default:
      return too_weak(arm, system, blocked);
  }
}

}  // namespace dualarm

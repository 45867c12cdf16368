#include "core/refuse_blocked.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/phase_plane/trace.h"
#include "core/shortfall.h"
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

/// Part of a torque below which what is missing of it is rounding.
constexpr double kTorqueShowing = 1e-9;

std::string place(double position) { return worded(position, " rad (", degrees(position), " deg)"); }

/// Two numbers, with six digits or as many as it takes to tell them apart.
std::pair<std::string, std::string> told_apart(double one, double other) {
  const auto digits = [](double number, int precision) {
    std::ostringstream text;
    text.precision(precision);
    text << number;
    return text.str();
  };
  int precision = 6;
  while (one != other && precision < 17 && digits(one, precision) == digits(other, precision)) ++precision;
  return {digits(one, precision), digits(other, precision)};
}

/// What would be enough: how much wider a limit of an arm has to be, if it is known.
class Remedy {
 public:
  Remedy(const Arm& arm, const Task& task, const FreeRange& free, const Blocked& blocked, const Budget& budget)
      : arm_(arm), task_(task), is_proven_(blocked.is_proven), budget_(budget) {
    arm_.joint_range = free.range;
  }

  std::optional<double> amount(WidenedLimit limit, std::optional<double> guess) const {
    return is_proven_ ? shortfall(arm_, task_, limit, guess, budget_) : std::nullopt;
  }

 private:
  Arm arm_;
  const Task& task_;
  bool is_proven_;
  const Budget& budget_;
};

Infeasible outside_range(const Arm& arm, const Blocked& blocked, const Remedy& remedy) {
  const double excess = std::max(arm.joint_range.lower - blocked.position, blocked.position - arm.joint_range.upper);
  const char* which = blocked.reason == BlockReason::kStartOutsideRange ? "start" : "goal";
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  const bool is_below = blocked.position < arm.joint_range.lower;
  evidence.relaxation = remedy.amount(is_below ? WidenedLimit::kRangeBelow : WidenedLimit::kRangeAbove, excess);
  return {reason_of(blocked.reason),
          worded("The ", which, " of ", arm.name, ", ", place(blocked.position), ", lies outside its joint range [",
                 arm.joint_range.lower, ", ", arm.joint_range.upper, "] rad by ", excess,
                 " rad; move it or widen the range."),
          evidence};
}

/// A start or goal whose velocity breaks its limit.
Infeasible beyond_velocity_limit(const Arm& arm, const JointState& state, BlockReason reason, const Remedy& remedy) {
  const double excess = std::max(arm.velocity.lower - state.velocity, state.velocity - arm.velocity.upper);
  const bool at_start = reason == BlockReason::kStartTooFast;
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = state.position;
  evidence.velocity = state.velocity;
  evidence.relaxation = remedy.amount(WidenedLimit::kVelocity, excess);
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
                       const Blocked& blocked, const Remedy& remedy) {
  const bool at_start = blocked.reason == BlockReason::kStartTooFast;
  const Wall wall = wall_of(free, state, at_start);
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  evidence.velocity = blocked.velocity;
  std::string advice =
      wall.object.empty() ? "give a larger range or more torque." : "give more torque or move the object.";
  const auto* line = std::get_if<TorqueSpeedLine>(&arm.torque);
  if (!at_start && line != nullptr && std::abs(state.velocity) >= line->no_load_speed) {
    advice = worded("give it a drive with a higher no-load speed: this one gives no torque at its no-load speed, ",
                    line->no_load_speed, " rad/s, and above.");
  } else if (blocked.position == wall.position) {
    evidence.first_body = wall.body;
    evidence.second_body = wall.object;
    if (const auto room = missing_room(system, blocked, at_start)) {
      const bool is_above = wall.position == free.range.upper;
      evidence.relaxation = remedy.amount(is_above ? WidenedLimit::kRangeAbove : WidenedLimit::kRangeBelow, *room);
      advice = worded("give ", *room, " rad more room, or more torque.");
    }
  }
  return {reason_of(blocked.reason),
          worded(arm.name, at_start ? " starts with " : " has to arrive with ", state.velocity, " rad/s at ",
                 place(state.position), story(state, wall, blocked, at_start), "; ",
                 !slower_helps(system, state, blocked, at_start) ? ""
                 : at_start                                      ? "start slower, or "
                                                                 : "arrive slower, or ",
                 advice),
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
    default:
      throw std::logic_error("not a matter of torque");
  }
}

/// Where a motion would have to break a velocity limit: full braking does not keep it, or full drive from the limit
/// does not get past what follows.
Infeasible beyond_keeping(const Arm& arm, const SingleJointArm& system, const Blocked& blocked, const Remedy& remedy) {
  const Interval limits = torque_limits(arm.torque, blocked.position, blocked.velocity);
  const bool is_lowest = blocked.extreme == Extreme::kLowest;
  const double needed = system.torque({blocked.position, blocked.velocity}, 0.0);
  const double available = is_lowest ? limits.lower : limits.upper;
  const bool brakes = is_lowest == (blocked.velocity > 0.0);
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  evidence.velocity = blocked.velocity;
  evidence.available_torque = available;
  std::string shortfall_of_torque;
  if ((is_lowest ? available - needed : needed - available) > kTorqueShowing * std::abs(available)) {
    const auto [need, have] = told_apart(needed, available);
    evidence.needed_torque = needed;
    shortfall_of_torque = worded(", where keeping that velocity needs ", need, " N m and ", have, " N m are available");
  }
  evidence.relaxation = remedy.amount(WidenedLimit::kVelocity, std::nullopt);
  const std::string wider = evidence.relaxation ? worded("a velocity limit ", *evidence.relaxation, " rad/s larger")
                                                : std::string("a larger velocity limit");
  return {
      reason_of(blocked.reason),
      worded(arm.name, " cannot keep its velocity limits [", arm.velocity.lower, ", ", arm.velocity.upper, "] rad/s: ",
             brakes ? "braking with full torque, it still gets faster than " : "even with full torque from ",
             blocked.velocity, " rad/s at ", place(blocked.position), shortfall_of_torque,
             brakes ? "" : " it does not get past what follows", "; give it ", wider, " or more torque."),
      evidence};
}

/// What the drive and gravity are apart.
std::string shortfall_of(double needed, double available, const Blocked& blocked, std::optional<double> relaxation) {
  const auto [need, have] = told_apart(needed, available);
  const bool gives_too_much = blocked.extreme == Extreme::kLowest ? available > 0.0 : available < 0.0;
  if (gives_too_much && needed != available) {
    return worded(need, " N m, and the drive gives no ", available > 0.0 ? "less" : "more", " than ", have,
                  " N m; let its torque limits reach ", need, " N m.");
  }
  const std::string advice = relaxation
                                 ? worded("; torque limits ", *relaxation, " N m wider would be enough, or less load.")
                                 : std::string("; give the drive more torque or the arm less load.");
  return needed == available ? worded("all of the ", have, " N m that are available, so that nothing is left", advice)
                             : worded(need, " N m and ", have, " N m are available", advice);
}

/// Where the torque falls short of what keeps the velocity.
Infeasible too_weak(const Arm& arm, const SingleJointArm& system, const Blocked& blocked, const Remedy& remedy) {
  const Interval limits = torque_limits(arm.torque, blocked.position, blocked.velocity);
  const double needed = system.torque({blocked.position, blocked.velocity}, 0.0);
  const double available = blocked.extreme == Extreme::kLowest ? limits.lower : limits.upper;
  Evidence evidence;
  evidence.arm = arm.name;
  evidence.position = blocked.position;
  if (blocked.velocity != 0.0) evidence.velocity = blocked.velocity;
  evidence.available_torque = available;
  const double missing = std::abs(needed - available);
  evidence.relaxation = remedy.amount(WidenedLimit::kTorque, missing > 0.0 ? std::optional(missing) : std::nullopt);
  // A state can be missed although the torque keeps the arm in it: there was too little room to get there.
  if (!(blocked.extreme == Extreme::kLowest ? needed <= available : needed >= available)) {
    return {reason_of(blocked.reason),
            worded(arm.name, " ", what_fails(blocked.reason), ": it would have to be at ", place(blocked.position),
                   " with ", blocked.velocity, " rad/s, and full torque, ", available,
                   " N m there, does not do it on the way; give the drive more torque, or start slower."),
            evidence};
  }
  evidence.needed_torque = needed;
  const std::string state = blocked.velocity == 0.0
                                ? "gravity needs "
                                : worded("with ", blocked.velocity, " rad/s, keeping that velocity needs ");
  return {reason_of(blocked.reason),
          worded(arm.name, " ", what_fails(blocked.reason), ": at ", place(blocked.position), " ", state,
                 shortfall_of(needed, available, blocked, evidence.relaxation)),
          evidence};
}

}  // namespace

Infeasible refuse_blocked(const Arm& arm, const Task& task, const SingleJointArm& system, const FreeRange& free,
                          const Blocked& blocked, const Budget& budget) {
  const Remedy remedy(arm, task, free, blocked, budget);
  switch (blocked.reason) {
    case BlockReason::kStartOutsideRange:
    case BlockReason::kGoalOutsideRange:
      return outside_range(arm, blocked, remedy);
    case BlockReason::kStartTooFast:
    case BlockReason::kGoalTooFast: {
      const JointState& state = blocked.reason == BlockReason::kStartTooFast ? task.start : task.goal;
      return arm.velocity.contains(state.velocity) ? out_of_room(arm, state, system, free, blocked, remedy)
                                                   : beyond_velocity_limit(arm, state, blocked.reason, remedy);
    }
    case BlockReason::kVelocityLimit:
      return beyond_keeping(arm, system, blocked, remedy);
    default:
      return too_weak(arm, system, blocked, remedy);
  }
}

}  // namespace dualarm

#include <cmath>
#include <ctime>
#include <exception>
#include <sstream>

#include "core/systems/single_joint_arm.h"
#include "tests/reference/energy_sweep.h"
#include "tests/reference/motion_judge.h"
#include "tests/reference/own_equation.h"
#include "tests/reference/own_integration.h"
#include "tests/reference/random_drive.h"
#include "tests/reference/steering_case.h"

namespace dualarm {
namespace {

/// Of the joint range, and of a velocity limit: what is as good as their edge.
constexpr double kAtTheEdge = 1e-6;
/// rad/s2 per rad/s2: an acceleration this small beside the arm's own counts as none. An arm as strong as gravity and
/// no stronger creeps towards the place where it stalls, for ever.
constexpr double kCreep = 5e-4;
/// rad and rad/s: states this close are the same.
constexpr double kSamePlace = 1e-12;
constexpr double kSameVelocity = 1e-7;
/// rad and rad/s of a step; s: of full braking past the goal, and how often it is looked at.
constexpr double kIntegration = 1e-11;
constexpr double kLongestMiss = 20.0;
constexpr double kMissStep = 5e-4;
/// Of the time to rest, and s: the steps near a rest, where the arm turns within one of the long ones.
constexpr double kMissShare = 0.2;
constexpr double kShortestMissStep = 1e-8;
/// s of computing: what one call may take.
constexpr double kLongestCall = 5.0;

const char* name_of(BlockReason reason) {
  switch (reason) {
    case BlockReason::kStartOutsideRange:
      return "start outside range";
    case BlockReason::kGoalOutsideRange:
      return "goal outside range";
    case BlockReason::kStartNotHoldable:
      return "start not holdable";
    case BlockReason::kGoalNotHoldable:
      return "goal not holdable";
    case BlockReason::kStartTooFast:
      return "start too fast";
    case BlockReason::kGoalTooFast:
      return "goal too fast";
    case BlockReason::kVelocityLimit:
      return "velocity limit";
    case BlockReason::kStalls:
      return "stalls";
    case BlockReason::kCannotBrake:
      return "cannot brake";
  }
  return "no reason";
}

class RefusalJudge {
 public:
  RefusalJudge(const MotionProblem& problem, const Blocked& blocked)
      : arm_(problem.arm), own_(problem.arm), start_(problem.start), goal_(problem.goal), blocked_(blocked) {
    const auto [lowest, highest] = own_.torques(blocked.position, blocked.velocity);
    slack_ = kCreep * (highest - lowest + std::abs(arm_.gravity.amplitude)) / arm_.inertia;
  }

  bool is_true() const {
    switch (blocked_.reason) {
      case BlockReason::kStartOutsideRange:
        return !arm_.joint_range.contains(start_.position);
      case BlockReason::kGoalOutsideRange:
        return !arm_.joint_range.contains(goal_.position);
      case BlockReason::kStartNotHoldable:
        return start_.velocity == 0.0 && !holds(start_.position);
      case BlockReason::kGoalNotHoldable:
        return goal_.velocity == 0.0 && !holds(goal_.position);
      case BlockReason::kStartTooFast:
        return !arm_.velocity.contains(start_.velocity) || leaves(start_, false);
      case BlockReason::kGoalTooFast:
        return !arm_.velocity.contains(goal_.velocity) || leaves(goal_, true) || comes_from_above();
      case BlockReason::kVelocityLimit:
        return pushes_on() || runs_out(goal_, false) || runs_out(start_, true);
      case BlockReason::kStalls:
        return falls_short() || misses(goal_, start_, true);
      case BlockReason::kCannotBrake:
        return falls_short() || misses(start_, goal_, false);
    }
    return false;
  }

 private:
  int sense() const { return blocked_.extreme == Extreme::kHighest ? 1 : -1; }

  bool holds(double position) const {
    return own_.acceleration(+1, position, 0.0) >= 0.0 && own_.acceleration(-1, position, 0.0) <= 0.0;
  }

  /// Whether the arm cannot be stopped inside the range and the limits, from a state on or, backwards, before it.
  bool leaves(JointState state, bool backwards) const {
    const auto stop = full_stop(arm_, state, backwards);
    const double margin = kAtTheEdge * arm_.joint_range.length();
    return !stop || stop->position <= arm_.joint_range.lower + margin ||
           stop->position >= arm_.joint_range.upper - margin;
  }

  /// Whether the goal is on its velocity limit where even full drive slows the arm down: it would come from above it.
  bool comes_from_above() const {
    const double direction = goal_.velocity > 0.0 ? 1.0 : -1.0;
    const double limit = direction > 0.0 ? arm_.velocity.upper : arm_.velocity.lower;
    return goal_.velocity / limit >= 1.0 - kAtTheEdge &&
           direction * own_.acceleration(static_cast<int>(direction), goal_.position, goal_.velocity) <= 0.0;
  }

  /// Whether at the place named the velocity is at its limit and full braking still speeds the arm up.
  bool pushes_on() const {
    const double limit = blocked_.velocity > 0.0 ? arm_.velocity.upper : arm_.velocity.lower;
    const double direction = blocked_.velocity > 0.0 ? 1.0 : -1.0;
    return blocked_.velocity / limit >= 1.0 - kAtTheEdge &&
           direction * own_.acceleration(-static_cast<int>(direction), blocked_.position, limit) >= -slack_;
  }

  /// Whether full drive from the limit at the place named comes to rest before a state's position; backwards, whether
  /// full braking that is to end there on the limit has to begin after it.
  bool runs_out(JointState to, bool backwards) const {
    const double clock = backwards ? -1.0 : 1.0;
    const double direction = blocked_.velocity > 0.0 ? 1.0 : -1.0;
    const bool highest = (direction > 0.0) != backwards;
    OwnIntegration<double> integration(arm_, highest ? 1.0 : 0.0, kIntegration);
    OwnState<double> state = {blocked_.position, blocked_.velocity};
    for (double time = 0.0; time < kLongestMiss; time += kMissStep) {
      if (clock * direction * (state[0] - to.position) >= 0.0) return false;
      if (direction * state[1] <= 0.0) return true;
      state = integration.run(state, clock * kMissStep, [](const OwnState<double>&, double) {});
    }
    return true;  // as good as at rest
  }

  /// Whether at the place named the extreme named is no acceleration in its own sense.
  bool falls_short() const {
    return sense() * own_.acceleration(sense(), blocked_.position, blocked_.velocity) <= slack_;
  }

  /// Whether full braking from a state passes the position of another faster than that is; backwards, whether full
  /// drive that is to end in a state has to pass the other faster.
  bool misses(JointState from, JointState to, bool backwards) const {
    const double clock = backwards ? -1.0 : 1.0;
    const double direction = from.velocity > 0.0 ? 1.0 : -1.0;
    const bool highest = (direction > 0.0) == backwards;
    OwnIntegration<double> integration(arm_, highest ? 1.0 : 0.0, kIntegration);
    OwnState<double> state = {from.position, from.velocity};
    const auto ignore = [](const OwnState<double>&, double) {};
    for (double time = 0.0; time < kLongestMiss && direction * state[1] > 0.0;) {
      const double to_rest = std::abs(state[1] / own_.acceleration(highest ? 1 : -1, state[0], state[1]));
      const double step = std::clamp(kMissShare * to_rest, kShortestMissStep, kMissStep);
      const OwnState<double> next = integration.run(state, clock * step, ignore);
      if (clock * direction * (next[0] - to.position) >= 0.0) return direction * state[1] >= direction * to.velocity;
      state = next;
      time += step;
    }
    return false;
  }

  const Arm& arm_;
  OwnEquation<double> own_;
  JointState start_;
  JointState goal_;
  const Blocked& blocked_;
  double slack_ = 0.0;  ///< rad/s2
};

std::vector<std::string> judge_blocked(const SteeringCase& steering, const Blocked& blocked) {
  std::vector<std::string> complaints;
  const std::string reason = name_of(blocked.reason);
  if (!RefusalJudge(steering.problem, blocked).is_true()) {
    std::ostringstream text;
    text.precision(17);
    text << "refused because: " << reason << " at " << blocked.position << " with " << blocked.velocity
         << ", which is not so";
    complaints.push_back(text.str());
  }
  if (!std::isfinite(blocked.position) || !std::isfinite(blocked.velocity) || std::isnan(blocked.lower_bound)) {
    complaints.push_back("refused with numbers that are none: " + reason);
  }
  const bool rests = steering.problem.start.velocity == 0.0 || steering.problem.goal.velocity == 0.0;
  const bool is_hold =
      blocked.reason == BlockReason::kStartNotHoldable || blocked.reason == BlockReason::kGoalNotHoldable;
  if (steering.drive != 0 && !(rests && is_hold) && (blocked.is_proven || steering.swings == Swings::kSearch)) {
    complaints.push_back("refused because: " + reason + ", although the arm was driven there");
  }
  return complaints;
}

std::vector<std::string> judge_motion(const SteeringCase& steering, const FastestMotion& motion) {
  const MotionProblem& problem = steering.problem;
  const double duration = motion.profile.duration();
  std::vector<std::string> complaints;
  if (motion.profile.stands_still()) {
    if (!(std::abs(problem.start.position - problem.goal.position) <= kSamePlace) ||
        !(std::abs(problem.start.velocity - problem.goal.velocity) <= kSameVelocity) || duration != 0.0) {
      complaints.push_back("stands still on the way");
    }
  } else {
    complaints = judge_quickly(problem.arm, problem.start, problem.goal, motion.profile.arcs());
  }
  if (!(motion.lower_bound <= duration * (1.0 + 1e-9))) complaints.push_back("its bound is above its duration");
  if (steering.drive != 0) {
    const double driven = drive_at_random(problem.arm, problem.start, steering.drive).duration;
    const bool claims_all = motion.minimum_over == MinimumOver::kAllMotions;
    if (!(motion.lower_bound <= driven)) complaints.push_back("its bound is above a motion's duration");
    if ((claims_all || steering.swings == Swings::kSearch) && !(duration <= driven)) {
      complaints.push_back("takes " + std::to_string(duration) + " s where " + std::to_string(driven) + " s will do");
    }
  }
  return complaints;
}

SteeringVerdict judge_call(const SteeringCase& steering) {
  const MotionProblem& problem = steering.problem;
  const SingleJointArm system(problem.arm);
  const std::clock_t begin = std::clock();
  const auto answer = fastest_motion(system, problem.start, problem.goal, steering.swings);
  const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  SteeringVerdict verdict;
  if (const auto* motion = std::get_if<FastestMotion>(&answer)) {
    verdict = {judge_motion(steering, *motion), true};
  } else {
    verdict.complaints = judge_blocked(steering, std::get<Blocked>(answer));
  }
  if (taken > kLongestCall) verdict.complaints.push_back("took " + std::to_string(taken) + " s");
  return verdict;
}

}  // namespace

SteeringVerdict judge_steering(const SteeringCase& steering) {
  try {
    return judge_call(steering);
  } catch (const std::exception& error) {
    return {{std::string("threw: ") + error.what()}, false};
  }
}

}  // namespace dualarm

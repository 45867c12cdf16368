#include "core/object_visit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/coordination/traffic.h"
#include "core/wording.h"

namespace dualarm {

namespace {

/// How far (s) the end of any meeting of an object with bodies of an arm, standing at a position (rad), is from a time.
double off(double until, const Problem& problem, int arm, double position, const std::vector<Body>& bodies,
           const TrackedBody& object, double clearance, const Budget& budget) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Interval& time : Traffic(problem.arms[arm].base, bodies, {object}, clearance, budget).times_at(position)) {
    nearest = std::min(nearest, time.upper == until ? 0.0 : std::abs(time.upper - until));
  }
  return nearest;
}

/// The one of least distance.
template <class Item, class Distance>
const Item& nearest_of(const std::vector<Item>& items, const Distance& distance) {
  return *std::min_element(items.begin(), items.end(),
                           [&](const Item& left, const Item& right) { return distance(left) < distance(right); });
}

}  // namespace

std::optional<ObjectVisit> last_goal_visit(const Problem& problem, double clearance, const Budget& budget) {
  std::optional<ObjectVisit> last;
  const std::vector<TrackedBody> objects = tracked_bodies(problem);
  for (int arm = 0; arm < kArmCount; ++arm) {
    const JointState& goal = problem.tasks[arm].goal;
    if (goal.velocity != 0.0) continue;
    const Traffic traffic(problem.arms[arm].base, moving_bodies(problem, arm), objects, clearance, budget);
    const IntervalList times = traffic.times_at(goal.position);
    if (times.empty() || times.back().upper <= (last ? last->until : 0.0)) continue;
    last = visit_until(problem, arm, goal.position, clearance, times.back().upper, budget);
  }
  return last;
}

ObjectVisit visit_until(const Problem& problem, int arm, double position, double clearance, double until,
                        const Budget& budget) {
  const std::vector<Body> bodies = moving_bodies(problem, arm);
  const std::vector<TrackedBody> objects = tracked_bodies(problem);
  const TrackedBody& object = nearest_of(objects, [&](const TrackedBody& one) {
    return off(until, problem, arm, position, bodies, one, clearance, budget);
  });
  const Body& body = nearest_of(
      bodies, [&](const Body& one) { return off(until, problem, arm, position, {one}, object, clearance, budget); });
  return {arm, position, object.body.name, body.name, until};
}

Infeasible refuse_visit(const Problem& problem, const ObjectVisit& visit, double margin) {
  const bool is_at_goal = visit.position == problem.tasks[visit.arm].goal.position;
  const std::string& name = problem.arms[visit.arm].name;
  Evidence evidence;
  evidence.arm = name;
  evidence.position = visit.position;
  evidence.first_body = visit.body;
  evidence.second_body = visit.object;
  return {is_at_goal ? InfeasibleReason::kGoalInCollision : InfeasibleReason::kObjectInSweep,
          worded(visit.object, " ends its track where ", name, is_at_goal ? " has to rest: at " : " has to pass: at ",
                 degrees(visit.position), " deg ", visit.body, " is then closer to it than the demanded ",
                 problem.options.clearance, " m and the ", margin, " m more for the proof, for good; move the ",
                 is_at_goal ? "goal" : "start or the goal", ", or lead the track on."),
          evidence};
}

}  // namespace dualarm

#include "core/goal_visit.h"

#include <algorithm>
#include <vector>

#include "core/coordination/moving_objects.h"
#include "core/wording.h"

namespace dualarm {

std::optional<GoalVisit> last_goal_visit(const Problem& problem, double clearance) {
  std::optional<GoalVisit> last;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const JointState& goal = problem.tasks[arm].goal;
    if (goal.velocity != 0.0) continue;
    const std::vector<Body> bodies = moving_bodies(problem, arm);
    const auto meets_until = [&](const std::vector<Body>& some, const TrackedBody& object) {
      return last_meeting(goal.position, problem.arms[arm].base, some, object, clearance);
    };
    for (const TrackedBody& object : tracked_bodies(problem)) {
      const double until = meets_until(bodies, object);
      if (until <= (last ? last->until : 0.0)) continue;
      const auto is_met_last = [&](const Body& body) { return meets_until({body}, object) >= until; };
      const auto met = std::find_if(bodies.begin(), bodies.end(), is_met_last);
      last = {arm, object.body.name, (met != bodies.end() ? *met : bodies.front()).name, until};
    }
  }
  return last;
}

Infeasible refuse_goal_visit(const Problem& problem, const GoalVisit& visit, double margin) {
  const double position = problem.tasks[visit.arm].goal.position;
  Evidence evidence;
  evidence.arm = problem.arms[visit.arm].name;
  evidence.position = position;
  evidence.first_body = visit.body;
  evidence.second_body = visit.object;
  return {InfeasibleReason::kGoalInCollision,
          worded(visit.object, " ends its track where ", problem.arms[visit.arm].name, " has to rest: at ",
                 degrees(position), " deg ", visit.body, " is then closer to it than the demanded ",
                 problem.options.clearance, " m and the ", margin,
                 " m more for the proof, for good; move the goal, or lead the track on."),
          evidence};
}

}  // namespace dualarm

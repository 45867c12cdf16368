#include "server/request/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/request/plan_options.h"
#include "server/request/robot.h"
#include "server/request/scene.h"
#include "server/request/tasks.h"
#include "server/request/trajectories.h"

namespace dualarm {
namespace {

template <typename Message>
Problem read_surroundings(const Message& message, const Field& request) {
  Problem problem;
  problem.arms = read_robot(message.has_robot() ? &message.robot() : nullptr, request);
  problem.objects = read_scene(message.scene(), request.child("scene"), problem.arms);
  return problem;
}

// A lower bound of the time (s) the arm takes between start and goal, there or back: a search may have it retreat, and
// an arm that is quick one way only would then answer with knots by the million. From rest to rest with accelerations
// of at most `up` and `down` it is sqrt(2 d (1/up + 1/down)); gravity adds to one what it takes from the other.
double shortest_duration(const Arm& arm, const Task& task) {
  const double distance = std::abs(task.goal.position - task.start.position);
  const double slower = std::min(-arm.velocity.lower, arm.velocity.upper);
  const double gravity = std::abs(arm.gravity.amplitude);
  const double up = std::max(arm.torque.upper + gravity, 0.0) / arm.inertia;
  const double down = std::max(-arm.torque.lower + gravity, 0.0) / arm.inertia;
  const double either = arm.torque.length() / arm.inertia;
  const double pull = up > 0.0 && down > 0.0 ? std::max(8.0 / either, 2.0 / up + 2.0 / down) : 8.0 / either;
  return std::max(distance / slower, std::sqrt(distance * pull));
}

// Asked only of requests without other violations: it needs sound limits.
void check_knot_count(const Problem& problem, const Field& request) {
  for (int i = 0; i < kArmCount; ++i) {
    const double knots = shortest_duration(loaded_arm(problem, i), problem.tasks[i]) / problem.options.knot_period;
    if (knots <= ranges::kMostKnots) continue;
    request.child("options").complain(
        "knot_period_s",
        fmt::format("is {} s, with which the motion of arm {} takes at least {:.0f} knots; at most {} are "
                    "served: raise it",
                    problem.options.knot_period, quoted(problem.arms[i].name), knots, ranges::kMostKnots));
  }
}

template <typename Wish>
Parsed<Wish> wish_or_violations(Wish wish, Violations violations) {
  if (!violations.empty()) return violations;
  return wish;
}

}  // namespace

Parsed<PlanWish> parse(const wire::PlanMotionRequest& message) {
  Violations violations;
  const Field request("", violations);
  const Field options = request.child("options");
  PlanWish wish;
  wish.problem = read_surroundings(message, request);
  wish.problem.tasks = read_tasks(message.tasks(), request, wish.problem.arms);
  wish.problem.options = read_plan_options(message.options(), options);
  wish.problem.options.region_model = read_region_model(message.options().region_model(), options, wish.problem.arms);
  wish.budget = read_planning_budget(message.options(), options);
  wish.validate_only = message.options().validate_only();
  if (violations.empty()) check_knot_count(wish.problem, request);
  return wish_or_violations(std::move(wish), std::move(violations));
}

Parsed<VerifyWish> parse(const wire::VerifyMotionRequest& message) {
  Violations violations;
  const Field request("", violations);
  VerifyWish wish;
  wish.problem = read_surroundings(message, request);
  wish.check_end_states = message.tasks_size() > 0;
  if (wish.check_end_states) wish.problem.tasks = read_tasks(message.tasks(), request, wish.problem.arms);
  wish.problem.options.clearance = request.number("clearance_m", message.clearance_m(), ranges::kSize);
  wish.trajectory = read_trajectories(message.trajectories(), request, wish.problem.arms);
  return wish_or_violations(std::move(wish), std::move(violations));
}

Parsed<RegionWish> parse(const wire::GetForbiddenRegionRequest& message) {
  Violations violations;
  const Field request("", violations);
  RegionWish wish;
  wish.problem = read_surroundings(message, request);
  wish.problem.options.clearance = request.number("clearance_m", message.clearance_m(), ranges::kSize);
  wish.problem.options.region_model = read_region_model(message.region_model(), request, wish.problem.arms);
  wish.resolution = ranges::kDefaultResolution;
  if (message.resolution() != 0) {
    request.number("resolution", message.resolution(), ranges::kResolution);
    wish.resolution = message.resolution();
  }
  return wish_or_violations(std::move(wish), std::move(violations));
}

}  // namespace dualarm

#include "server/request/requests.h"

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

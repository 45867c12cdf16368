#include "server/request/requests.h"

#include <algorithm>

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

int read_resolution(int resolution, const Range& range, int by_default, const Field& request) {
  if (resolution == 0) return by_default;
  request.number("resolution", resolution, range);
  return resolution;
}

template <typename Wish>
Parsed<Wish> wish_or_violations(Wish wish, Violations violations) {
  if (!violations.empty()) return violations;
  return wish;
}

}  // namespace

Parsed<PlanWish> parse(const wire::PlanMotionRequest& message, const RequestLimits& limits) {
  Violations violations;
  const Field request("", violations, limits);
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

Parsed<VerifyWish> parse(const wire::VerifyMotionRequest& message, const RequestLimits& limits) {
  Violations violations;
  const Field request("", violations, limits);
  VerifyWish wish;
  wish.problem = read_surroundings(message, request);
  wish.check_end_states = message.tasks_size() > 0;
  if (wish.check_end_states) wish.problem.tasks = read_tasks(message.tasks(), request, wish.problem.arms);
  wish.problem.options.clearance = request.number("clearance_m", message.clearance_m(), ranges::kSize);
  wish.trajectory = read_trajectories(message.trajectories(), request, wish.problem.arms);
  return wish_or_violations(std::move(wish), std::move(violations));
}

Parsed<RegionWish> parse(const wire::GetForbiddenRegionRequest& message, const RequestLimits& limits) {
  Violations violations;
  const Field request("", violations, limits);
  RegionWish wish;
  wish.problem = read_surroundings(message, request);
  wish.problem.options.clearance = request.number("clearance_m", message.clearance_m(), ranges::kSize);
  wish.problem.options.region_model = read_region_model(message.region_model(), request, wish.problem.arms);
  wish.resolution = read_resolution(message.resolution(), ranges::kResolution, ranges::kDefaultResolution, request);
  return wish_or_violations(std::move(wish), std::move(violations));
}

Parsed<PortraitWish> parse(const wire::GetPhasePortraitRequest& message, const RequestLimits& limits) {
  Violations violations;
  const Field request("", violations, limits);
  PortraitWish wish;
  wish.problem = read_surroundings(message, request);
  if (message.has_task()) {
    const auto [arm, task] = read_task(message.task(), request.child("task"), wish.problem.arms);
    wish.arm = std::max(arm, 0);
    wish.problem.tasks[wish.arm] = task;
  } else {
    request.complain_missing("task", "give the arm that is to be drawn, its start and its goal");
  }
  wish.resolution =
      read_resolution(message.resolution(), ranges::kCurveResolution, ranges::kDefaultCurveResolution, request);
  return wish_or_violations(std::move(wish), std::move(violations));
}

}  // namespace dualarm

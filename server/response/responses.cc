#include "server/response/responses.h"

#include "server/response/infeasible.h"
#include "server/response/plan.h"
#include "server/response/portrait.h"
#include "server/response/undecided.h"
#include "server/response/verification.h"

namespace dualarm {
namespace {

wire::Statistics statistics_message(const Statistics& statistics) {
  wire::Statistics message;
  message.set_planning_time_s(statistics.planning_seconds);
  message.set_analytic_time_s(statistics.analytic_seconds);
  message.set_verification_time_s(statistics.verification_seconds);
  message.set_fallback_time_s(statistics.fallback_seconds);
  message.set_distance_query_count(statistics.distance_query_count);
  message.set_fallback_evaluation_count(statistics.fallback_evaluation_count);
  message.set_fallback_node_count(statistics.fallback_node_count);
  message.set_fallback_memory_bytes(static_cast<std::int64_t>(statistics.fallback_memory_bytes));
  return message;
}

wire::JointRange range_message(const Interval& range) {
  wire::JointRange message;
  message.set_min_rad(range.lower);
  message.set_max_rad(range.upper);
  return message;
}

}  // namespace

wire::PlanMotionResponse response_message(const Outcome& outcome) {
  wire::PlanMotionResponse message;
  if (const auto* plan = std::get_if<Plan>(&outcome.answer)) *message.mutable_plan() = plan_message(*plan);
  if (const auto* infeasible = std::get_if<Infeasible>(&outcome.answer)) {
    *message.mutable_infeasible() = infeasible_message(*infeasible);
  }
  if (const auto* undecided = std::get_if<Undecided>(&outcome.answer)) {
    *message.mutable_undecided() = undecided_message(*undecided);
  }
  *message.mutable_statistics() = statistics_message(outcome.statistics);
  return message;
}

wire::VerifyMotionResponse response_message(const Verification& verification) {
  wire::VerifyMotionResponse message;
  *message.mutable_verification() = verification_message(verification);
  return message;
}

wire::GetForbiddenRegionResponse response_message(const std::vector<Contour>& contours, const Problem& problem) {
  wire::GetForbiddenRegionResponse message;
  for (const Contour& contour : contours) {
    wire::Contour& added = *message.add_contours();
    added.mutable_theta1_rad()->Add(contour.theta1.begin(), contour.theta1.end());
    added.mutable_theta2_rad()->Add(contour.theta2.begin(), contour.theta2.end());
  }
  *message.mutable_theta1_range() = range_message(problem.arms[0].joint_range);
  *message.mutable_theta2_range() = range_message(problem.arms[1].joint_range);
  return message;
}

wire::GetPhasePortraitResponse response_message(const ArmPortrait& portrait) { return portrait_message(portrait); }

}  // namespace dualarm

#include "clients/cpp/plan_report.h"

#include <fmt/format.h>

#include "clients/cpp/verification_report.h"
#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

std::string arm_lines(const Plan& plan) {
  std::string lines =
      fmt::format("\n  {:<12} {:>12} {:>12} {:>14} {:>14}\n", "arm", "starts at", "moves for", "from", "to");
  for (const ArmTrajectory& trajectory : plan.trajectories()) {
    const auto& position = trajectory.knots().position_rad();
    const bool empty = position.empty();
    lines += fmt::format("  {:<12} {:>12} {:>12} {:>14} {:>14}\n", trajectory.arm(), seconds(trajectory.start_time_s()),
                         seconds(trajectory.duration_s()), empty ? "-" : degrees(position[0]),
                         empty ? "-" : degrees(position[position.size() - 1]));
  }
  return lines + "\n";
}

std::string safe_delay_lines(const Plan& plan) {
  const auto& intervals = plan.certificate().safe_start_delays_s();
  if (intervals.empty() || plan.trajectories_size() != 2) return "";
  std::string text;
  for (const Interval& interval : intervals) {
    text += fmt::format("{}[{:.6f}, {:.6f}]", text.empty() ? "" : ", ", interval.min(), interval.max());
  }
  return fmt::format("  safe delays  {} may start later than {} by {} s\n", plan.trajectories(1).arm(),
                     plan.trajectories(0).arm(), text);
}

std::string lines_of(const Plan& plan) {
  const Certificate& certificate = plan.certificate();
  std::string lines =
      fmt::format("  duration     {}, method {}\n", seconds(plan.duration_s()), words_for(plan.method()));
  lines += fmt::format("  lower bound  {}, gap {}\n", seconds(certificate.lower_bound_s()), percent(certificate.gap()));
  lines += fmt::format("  claim        {}\n", claim_sentence(plan));
  return lines + arm_lines(plan) + verification_lines(plan.verification()) + safe_delay_lines(plan);
}

std::string lines_of(const Infeasible& infeasible) {
  return fmt::format("  reason       {}\n  because      {}\n", words_for(infeasible.reason()),
                     infeasible.explanation());
}

std::string lines_of(const Undecided& undecided) {
  std::string lines = fmt::format("  because      {}\n", undecided.explanation());
  for (const std::string& tried : undecided.tried()) lines += fmt::format("  tried        {}\n", tried);
  return lines + fmt::format("  lower bound  {}\n", seconds(undecided.lower_bound_s()));
}

}  // namespace

std::string plan_report(const std::string& name, const PlanMotionResponse& response) {
  std::string text;
  switch (response.outcome_case()) {
    case PlanMotionResponse::kPlan:
      text = fmt::format("{}: a verified plan\n\n{}", name, lines_of(response.plan()));
      break;
    case PlanMotionResponse::kInfeasible:
      text =
          fmt::format("{}: no plan exists within what the request allows\n\n{}", name, lines_of(response.infeasible()));
      break;
    case PlanMotionResponse::kUndecided:
      text = fmt::format("{}: undecided, no plan was found and none is excluded\n\n{}", name,
                         lines_of(response.undecided()));
      break;
    default:
      return fmt::format("{}: the request is valid\n", name);
  }
  return text + fmt::format("  took         {:.3f} ms\n", 1e3 * response.statistics().planning_time_s());
}

}  // namespace dualarm

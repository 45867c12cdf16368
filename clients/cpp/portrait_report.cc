#include "clients/cpp/portrait_report.h"

#include <fmt/format.h>

#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

std::string state_columns(const JointState& state) {
  return fmt::format(" {:>14} {:>18}", degrees(state.position_rad()),
                     fmt::format("{:.6f} rad/s", state.velocity_rad_per_s()));
}

std::string arc_lines(const GetPhasePortraitResponse& response) {
  std::string lines = fmt::format("\n  {:<12} {:>12} {:>12} {:>14} {:>18} {:>14} {:>18}\n", "arc", "begins at", "lasts",
                                  "from", "with", "to", "with");
  for (const Arc& arc : response.arcs()) {
    lines += fmt::format("  {:<12} {:>12} {:>12}", words_for(arc.kind()), seconds(arc.start_time_s()),
                         seconds(arc.end_time_s() - arc.start_time_s()));
    lines += state_columns(arc.start()) + state_columns(arc.end()) + "\n";
  }
  return lines;
}

std::string switch_lines(const GetPhasePortraitResponse& response) {
  std::string lines;
  for (int k = 1; k < response.arcs_size(); ++k) {
    const Arc& arc = response.arcs(k);
    const bool turns = arc.start().velocity_rad_per_s() == 0.0;
    lines += fmt::format("  {:<12} {:>12} {:>12}", turns ? "turn at" : "switch at", seconds(arc.start_time_s()), "");
    lines += state_columns(arc.start()) +
             fmt::format("   {} to {}\n", words_for(response.arcs(k - 1).kind()), words_for(arc.kind()));
  }
  return lines.empty() ? "" : "\n" + lines;
}

std::string motion_lines(const GetPhasePortraitResponse& response) {
  std::string lines = fmt::format("  duration     {}\n", seconds(response.duration_s()));
  lines += fmt::format("  lower bound  {}\n", seconds(response.lower_bound_s()));
  lines += fmt::format("  claim        {}\n", claim_sentence(response));
  if (response.arcs().empty()) return lines + "  stands still, it is at its goal already\n";
  return lines + arc_lines(response) + switch_lines(response);
}

}  // namespace

std::string portrait_report(const std::string& name, const std::string& arm, const GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) {
    const Infeasible& infeasible = response.infeasible();
    return fmt::format("{}, {}: no motion exists\n\n  reason       {}\n  because      {}\n", name, arm,
                       words_for(infeasible.reason()), infeasible.explanation());
  }
  if (response.has_undecided()) {
    const Undecided& undecided = response.undecided();
    return fmt::format("{}, {}: undecided\n\n  because      {}\n  lower bound  {}\n", name, arm,
                       undecided.explanation(), seconds(undecided.lower_bound_s()));
  }
  return fmt::format("{}, {}: the fastest motion with nothing in its way\n\n{}", name, arm, motion_lines(response));
}

std::string claim_sentence(const GetPhasePortraitResponse& response) {
  switch (response.claim()) {
    case CLAIM_OPTIMAL:
      return "Proven optimal: no motion of any kind is faster.";
    case CLAIM_OPTIMAL_MONOTONE:
      return "No motion that never turns back is faster; no faster swing was found.";
    default:
      return "The fastest of the motions that were searched; a faster one may exist.";
  }
}

}  // namespace dualarm

#include "clients/cpp/plan_table.h"

#include <fmt/format.h>

#include <cmath>

#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr const char* kLayout = "{:<16} {:<13} {:>10} {:>10} {:>12} {:>15} {:>8} {:>14} {:>10}\n";

std::string number(double value) { return fmt::format("{:.6f}", value); }

std::string moving_time(const Plan& plan, int arm) {
  return arm < plan.trajectories_size() ? number(plan.trajectories(arm).duration_s()) : "-";
}

std::string row_without_plan(const std::string& name, const std::string& outcome, const std::string& explanation) {
  return fmt::format("{:<16} {:<13} {}\n", name, outcome, explanation.substr(0, explanation.find('\n')));
}

std::string row_of(const std::string& name, const Plan& plan, const Statistics& statistics) {
  const double metres = plan.verification().min_clearance_m();
  return fmt::format(fmt::runtime(kLayout), name, words_for(plan.method()), moving_time(plan, 0), moving_time(plan, 1),
                     number(plan.duration_s()), number(plan.certificate().lower_bound_s()),
                     fmt::format("{:.3f}", 100.0 * plan.certificate().gap()),
                     std::isinf(metres) ? "unlimited" : number(metres),
                     fmt::format("{:.3f}", 1e3 * statistics.planning_time_s()));
}

}  // namespace

std::string table_header() {
  const std::string titles = fmt::format(fmt::runtime(kLayout), "scenario", "method", "T1 [s]", "T2 [s]",
                                         "duration [s]", "lower bound [s]", "gap [%]", "clearance [m]", "took [ms]");
  return titles + std::string(titles.size() - 1, '-') + "\n";
}

std::string table_row(const std::string& name, const PlanMotionResponse& response) {
  if (response.has_plan()) return row_of(name, response.plan(), response.statistics());
  if (response.has_infeasible()) return row_without_plan(name, "infeasible", response.infeasible().explanation());
  if (response.has_undecided()) return row_without_plan(name, "undecided", response.undecided().explanation());
  return row_without_plan(name, "valid", "only validated, as the request asks");
}

std::string table_row(const std::string& name, const std::string& error) {
  return row_without_plan(name, "ERROR", error);
}

}  // namespace dualarm

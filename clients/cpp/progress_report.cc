#include "clients/cpp/progress_report.h"

#include <fmt/format.h>

#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

std::string line_of(const Progress& progress) {
  std::string line = fmt::format("{:8.1f} s  {}", progress.elapsed_s(), progress.phase());
  if (progress.has_best_duration_s()) line += fmt::format(", best plan {:.6f} s", progress.best_duration_s());
  if (progress.lower_bound_s() > 0.0) line += fmt::format(", lower bound {:.6f} s", progress.lower_bound_s());
  if (progress.fallback_evaluation_count() > 0) {
    line += fmt::format(", {} evaluations", progress.fallback_evaluation_count());
  }
  return line + "\n";
}

}  // namespace

std::string progress_line(const PlanMotionStreamResponse& event) {
  if (event.has_progress()) return line_of(event.progress());
  if (!event.has_incumbent()) return "";
  const Plan& plan = event.incumbent();
  return fmt::format("{:>10}  a plan of {:.6f} s by {}, at most {:.3f} % above the best possible\n", "",
                     plan.duration_s(), words_for(plan.method()), 100.0 * plan.certificate().gap());
}

}  // namespace dualarm

#include "clients/cpp/verification_report.h"

#include <fmt/format.h>

#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

std::string utilisation(const char* limit, const Utilisation& use) {
  return fmt::format("{} {:.2f} % ({} at {})", limit, 100.0 * use.value(), use.arm(), seconds(use.time_s()));
}

std::string clearance_text(const Verification& verification) {
  std::string text = clearance(verification.min_clearance_m());
  if (!verification.has_closest()) return text;
  const ClosestApproach& closest = verification.closest();
  return text + fmt::format(" between {} and {} at {}", closest.body_a(), closest.body_b(), seconds(closest.time_s()));
}

}  // namespace

std::string verification_lines(const Verification& verification) {
  std::string lines = fmt::format("  clearance    {}, {}\n", clearance_text(verification),
                                  verification.collision_free() ? "proven at every instant" : "NOT proven");
  lines += fmt::format("  limits used  {}\n", utilisation("torque", verification.torque_utilisation()));
  lines += fmt::format("               {}\n", utilisation("velocity", verification.velocity_utilisation()));
  lines += fmt::format("               {}\n", utilisation("joint range", verification.range_utilisation()));
  for (const Violation& violation : verification.violations()) {
    lines += fmt::format("  BROKEN       {}\n", violation.explanation());
  }
  return lines;
}

bool is_verified(const Verification& verification) {
  return verification.collision_free() && verification.violations().empty();
}

}  // namespace dualarm

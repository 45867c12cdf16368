#include "clients/cpp/verification_report.h"

#include <fmt/format.h>

#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

// A use without an arm was never looked at: the verifier stopped at knots that are no motion.
std::string utilisation(const char* limit, const Utilisation& use) {
  if (use.arm().empty()) return fmt::format("{} not judged", limit);
  return fmt::format("{} {} ({} at {})", limit, percent(use.value()), use.arm(), seconds(use.time_s()));
}

bool is_judged(const Verification& verification) {
  return verification.collision_free() || verification.has_closest() ||
         !verification.torque_utilisation().arm().empty();
}

// Sentences begin with the name of the arm, which a trajectory may lack.
std::string demand(const Violation& violation) {
  const std::string& text = violation.explanation();
  return text.starts_with(' ') ? "a trajectory that names no arm" + text : text;
}

std::string clearance_text(const Verification& verification) {
  std::string text = clearance(verification.min_clearance_m());
  if (!verification.has_closest()) return text;
  const ClosestApproach& closest = verification.closest();
  return text + fmt::format(" between {} and {} at {}", closest.body_a(), closest.body_b(), seconds(closest.time_s()));
}

}  // namespace

std::string verification_lines(const Verification& verification) {
  std::string lines;
  if (is_judged(verification)) {
    lines += fmt::format("  clearance    {}, {}\n", clearance_text(verification),
                         verification.collision_free() ? "proven at every instant" : "NOT proven");
    lines += fmt::format("  limits used  {}\n", utilisation("torque", verification.torque_utilisation()));
    lines += fmt::format("               {}\n", utilisation("velocity", verification.velocity_utilisation()));
    lines += fmt::format("               {}\n", utilisation("joint range", verification.range_utilisation()));
  } else {
    lines += "  not judged   clearance and limits: the trajectories are no motion\n";
  }
  for (const Violation& violation : verification.violations()) {
    lines += fmt::format("  BROKEN       {}\n", demand(violation));
  }
  return lines;
}

bool is_verified(const Verification& verification) {
  return verification.collision_free() && verification.violations().empty();
}

}  // namespace dualarm

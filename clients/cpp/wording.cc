#include "clients/cpp/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dualarm {
namespace {

using namespace planning::v1;

// "REASON_START_IN_COLLISION" without "REASON_", in small letters, `between` for each underscore.
std::string plain(const std::string& name, const std::string& prefix, char between) {
  std::string text = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
  std::transform(text.begin(), text.end(), text.begin(),
                 [between](char c) { return c == '_' ? between : static_cast<char>(std::tolower(c)); });
  return text;
}

/// What the lower bound rests on.
std::string bound_words(const Plan& plan) {
  const Certificate& certificate = plan.certificate();
  if (certificate.source() == LOWER_BOUND_SOURCE_MOVING_OBJECT) {
    const ObjectVisit& visit = certificate.visit();
    const double rest = certificate.lower_bound_s() - visit.until_s();
    const std::string on = rest > 0.0 ? fmt::format(", and from there it takes {} more", seconds(rest)) : "";
    return fmt::format("{} is in the way of {} at {} until {}{}", visit.object(), visit.arm(),
                       degrees(visit.position_rad()), seconds(visit.until_s()), on);
  }
  if (certificate.source() != LOWER_BOUND_SOURCE_PASSAGE || !certificate.has_gate()) {
    return fmt::format("the slower arm on its own takes at least {}", seconds(certificate.lower_bound_s()));
  }
  const std::string& pinned = certificate.gate().pinned_arm();
  std::string other = "the other arm";
  for (const ArmTrajectory& trajectory : plan.trajectories()) {
    if (trajectory.arm() != pinned) other = trajectory.arm();
  }
  return fmt::format("{} and {} have to pass each other where {} is at {} and {} at {}, which takes {}", pinned, other,
                     pinned, degrees(certificate.gate().pinned_position_rad()), other,
                     degrees(certificate.gate().corner_position_rad()), seconds(certificate.lower_bound_s()));
}

}  // namespace

std::string words_for(Method method) { return plain(Method_Name(method), "METHOD_", '-'); }

std::string words_for(ArcKind kind) { return plain(ArcKind_Name(kind), "ARC_KIND_", ' '); }

std::string words_for(Reason reason) { return plain(Reason_Name(reason), "REASON_", ' '); }

std::string claim_sentence(const Plan& plan) {
  const Certificate& certificate = plan.certificate();
  const std::string why = bound_words(plan);
  switch (certificate.claim()) {
    case CLAIM_OPTIMAL:
      return fmt::format("Proven optimal: no motion of any kind is faster, because {}.", why);
    case CLAIM_OPTIMAL_MONOTONE:
      return "No motion in which each arm only moves towards its goal, or waits, is faster.";
    default:
      return fmt::format("A faster motion may exist; this one is at most {} above the proven lower bound: {}.",
                         percent(certificate.gap()), why);
  }
}

std::string seconds(double value) { return fmt::format("{:.6f} s", value); }

std::string degrees(double radians) { return fmt::format("{:.2f} deg", to_degrees(radians)); }

std::string clearance(double metres) { return std::isinf(metres) ? "unlimited" : fmt::format("{:.6f} m", metres); }

std::string percent(double share) {
  const double value = 100.0 * share;
  return std::abs(value) < 1e6 ? fmt::format("{:.2f} %", value) : fmt::format("{:.2e} %", value);
}

double to_degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace dualarm

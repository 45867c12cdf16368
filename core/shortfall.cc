#include "core/shortfall.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/phase_plane/swing.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

/// Part of an amount by which a limit may be too narrow, and too wide, beside it.
constexpr double kBeside = 5e-4;
/// Part of an amount to which it is found.
constexpr double kFound = 1e-6;
/// Parts of the limit's own size that are tried first and last, and the ratio between two tries. After two revolutions
/// of range, gravity has nothing new.
constexpr double kFirst = 1e-13;
constexpr double kLast = 1e6;
constexpr double kLastOfRange = 4.0;
constexpr double kRatio = 8.0;
/// Entries of a table up to which its limits are widened again and again.
constexpr std::size_t kMostEntries = 1000;

Interval wider(const Interval& limits, double amount) { return {limits.lower - amount, limits.upper + amount}; }

TorqueLimit wider(TorqueLimit limit, double amount) {
  if (auto* constant = std::get_if<Interval>(&limit)) *constant = wider(*constant, amount);
  if (auto* line = std::get_if<TorqueSpeedLine>(&limit)) line->stall_torque += amount;
  if (auto* table = std::get_if<TorqueTable>(&limit)) {
    for (Interval& entry : table->limits) entry = wider(entry, amount);
  }
  return limit;
}

/// The size that amounts are compared with, in the limit's unit.
double size_of(const Arm& arm, WidenedLimit limit) {
  const auto larger = [](const Interval& interval) {
    const double most = std::max(std::abs(interval.lower), std::abs(interval.upper));
    return std::isfinite(most) ? most : std::min(std::abs(interval.lower), std::abs(interval.upper));
  };
  switch (limit) {
    case WidenedLimit::kTorque:
      return std::max(larger(torque_bounds(arm.torque)), std::abs(arm.gravity.amplitude));
    case WidenedLimit::kVelocity:
      return larger(arm.velocity);
    default:
      return std::numbers::pi;
  }
}

bool is_refused(const Arm& arm, const Task& task) {
  const auto motion = fastest_motion(SingleJointArm(arm), task.start, task.goal, Swings::kSkip);
  const auto* blocked = std::get_if<Blocked>(&motion);
  return blocked != nullptr && blocked->is_proven;
}

bool moves(const Arm& arm, const Task& task, const Budget& budget) {
  const SingleJointArm system(arm);
  const auto motion = fastest_motion(system, task.start, task.goal, Swings::kSkip);
  const auto* blocked = std::get_if<Blocked>(&motion);
  return blocked == nullptr || (!blocked->is_proven && finds_swing(system, task.start, task.goal, budget));
}

}  // namespace

Arm with_wider(const Arm& arm, WidenedLimit limit, double amount) {
  Arm changed = arm;
  switch (limit) {
    case WidenedLimit::kTorque:
      changed.torque = wider(arm.torque, amount);
      break;
    case WidenedLimit::kVelocity:
      changed.velocity = wider(arm.velocity, amount);
      break;
    case WidenedLimit::kRangeBelow:
      changed.joint_range.lower -= amount;
      break;
    case WidenedLimit::kRangeAbove:
      changed.joint_range.upper += amount;
      break;
  }
  return changed;
}

std::optional<double> shortfall(const Arm& arm, const Task& task, WidenedLimit limit, std::optional<double> guess,
                                const Budget& budget) {
  const auto* table = std::get_if<TorqueTable>(&arm.torque);
  if (table != nullptr && table->limits.size() > kMostEntries) return std::nullopt;
  const auto is_too_little = [&](double amount) { return is_refused(with_wider(arm, limit, amount), task); };
  const auto is_enough = [&](double amount) {
    return moves(with_wider(arm, limit, amount * (1.0 + kBeside)), task, budget);
  };
  if (guess && is_too_little(*guess * (1.0 - kBeside)) && !is_too_little(*guess * (1.0 + kBeside))) {
    return is_enough(*guess) ? guess : std::nullopt;
  }
  const double size = size_of(arm, limit);
  const bool is_range = limit == WidenedLimit::kRangeBelow || limit == WidenedLimit::kRangeAbove;
  const double last = size * (is_range ? kLastOfRange : kLast);
  double low = 0.0;
  double high = kFirst * size;
  if (!is_too_little(high)) return std::nullopt;
  while (is_too_little(high)) {
    if (high >= last || budget.exhausted()) return std::nullopt;
    low = high;
    high = std::min(kRatio * high, last);
  }
  while (high - low > kFound * high) {
    if (budget.exhausted()) return std::nullopt;
    const double middle = 0.5 * (low + high);
    (is_too_little(middle) ? low : high) = middle;
  }
  return is_enough(high) ? std::optional(high) : std::nullopt;
}

}  // namespace dualarm

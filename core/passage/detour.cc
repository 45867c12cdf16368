#include "core/passage/detour.h"

#include <algorithm>
#include <variant>

#include "core/passage/joined.h"
#include "core/phase_plane/time_optimal.h"

namespace dualarm {
namespace {

/// Way (rad) below which a detour is none.
constexpr double kNoDetour = 1e-9;

}  // namespace

Detours::Detours(const Traveller& traveller, double towards, Hurry hurry) : traveller_(&traveller) {
  const double start = traveller.start.position;
  const double goal = traveller.goal.position;
  const double from = hurry == Hurry::kEarlyArrival ? start : goal;
  const double to = hurry == Hurry::kEarlyArrival ? goal : start;
  const double aim = towards != from ? towards : to;
  direction_ = aim < from ? -1.0 : 1.0;
  base_ = direction_ > 0.0 ? std::max(start, goal) : std::min(start, goal);
}

std::optional<Profile> Detours::motion(double excess) const {
  if (excess <= kNoDetour) return traveller_->fastest;
  const System& system = *traveller_->system;
  const JointState turn = {base_ + direction_ * excess, 0.0};
  const auto there = fastest_motion(system, traveller_->start, turn, Swings::kSkip);
  const auto* out = std::get_if<FastestMotion>(&there);
  if (out == nullptr) return std::nullopt;
  const auto back = fastest_motion(system, turn, traveller_->goal, Swings::kSkip);
  const auto* home = std::get_if<FastestMotion>(&back);
  if (home == nullptr) return std::nullopt;
  return joined(system, out->profile, home->profile);
}

double Detours::of(const Profile& motion) const {
  const Interval extent = motion.extent();
  return std::max(0.0, direction_ > 0.0 ? extent.upper - base_ : base_ - extent.lower);
}

}  // namespace dualarm

#include "core/fallback/alignment.h"

#include <algorithm>
#include <utility>

namespace dualarm {
namespace {

/// Relative difference of durations that are the same.
constexpr double kSameDuration = 1e-12;

/// Halvings of the span between the shortest conceivable and the shortest proven duration of a plan.
constexpr int kBisections = 6;

}  // namespace

std::optional<Aligned> Alignment::shortest(const Itinerary& itinerary, int leader, double end) {
  const double least = std::max(itinerary.busy_time(0), itinerary.busy_time(1));
  if (least >= end) return std::nullopt;
  Itinerary shorter = itinerary;
  if (!proves(shorter, leader, end)) {
    leader = 1 - leader;
    shorter = itinerary;
    if (!proves(shorter, leader, end)) return std::nullopt;
  }
  Itinerary trial = itinerary;
  if (proves(trial, leader, least)) return Aligned{std::move(trial), leader};
  double too_short = least;
  for (int i = 0; i < kBisections && !budget_.exhausted(); ++i) {
    const double middle = 0.5 * (too_short + end);
    trial = itinerary;
    if (proves(trial, leader, middle)) {
      end = middle;
      shorter = std::move(trial);
    } else {
      too_short = middle;
    }
  }
  return Aligned{std::move(shorter), leader};
}

bool Alignment::proves(Itinerary& itinerary, int leader, double end) {
  itinerary.align(leader, end);
  return proves_as_is(itinerary, end);
}

bool Alignment::proves_as_is(Itinerary& itinerary, double end) {
  ++evaluations_;
  if (!itinerary.settle(end, budget_)) return false;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (!itinerary.leave_by(arm, rules_.max_start_delay)) return false;
  }
  return itinerary.duration() <= end * (1.0 + kSameDuration) && proves_free(itinerary);
}

/// Most plans collide where others have just done so, and to see that takes a tenth of a proof.
bool Alignment::proves_free(const Itinerary& itinerary) {
  const std::array<Track, kArmCount> tracks = itinerary.tracks();
  const double duration = itinerary.duration();
  for (const double time : collisions_) {
    if (time < duration && proof_.collide_at(tracks, time)) return false;
  }
  const auto unproven = proof_.where_unproven(tracks, {0.0, duration});
  if (unproven) collisions_[next_collision_++ % collisions_.size()] = *unproven;
  return !unproven;
}

}  // namespace dualarm

#include "core/fallback/refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dualarm {
namespace {

/// Relative gain in duration below which a change is not worth a proof.
constexpr double kWorthwhileGain = 1e-5;

/// What a second of waiting between legs counts against a second of duration: a plan that waits less at no cost in
/// duration is taken, because the other arm can often use the room.
constexpr double kWaitWeight = 0.1;

/// Halvings of the span between the shortest conceivable and the shortest proven duration of a changed plan.
constexpr int kBisections = 6;

/// How often a trial consists of one more change.
constexpr double kAnotherChange = 0.3;

/// Shares of the kinds of change; the rest of them moves rests.
constexpr double kDropShare = 0.1;
constexpr double kInsertShare = 0.1;
constexpr double kWaitShare = 0.15;

/// How often a rest is moved at all when rests are moved, and how often a wait is dropped when waits are changed.
constexpr double kMoveChance = 0.6;
constexpr double kNoWaitChance = 0.5;
constexpr std::array kKept = {Keep::kWait, Keep::kNextStart, Keep::kNextArrival};

/// How often the other order of the arms is tried first.
constexpr double kOtherLeaderChance = 0.1;

}  // namespace

Refinement::Refinement(const Systems& systems, const ClearanceProof& proof, Itinerary first, double lower_bound,
                       Random& random, const Budget& budget)
    : systems_(systems),
      proof_(proof),
      best_(std::move(first)),
      duration_(best_.duration()),
      waits_(best_.waits_between()),
      lower_bound_(lower_bound),
      random_(random),
      budget_(budget) {}

void Refinement::run(int evaluation_limit) {
  consider(best_);
  while (evaluations_ < evaluation_limit && duration_ > lower_bound_ * (1.0 + kWorthwhileGain) &&
         !budget_.exhausted()) {
    ++evaluations_;
    consider(changed());
  }
}

Itinerary Refinement::changed() {
  Itinerary candidate = best_;
  do {
    change_once(candidate);
  } while (random_.chance(kAnotherChange));
  return candidate;
}

void Refinement::change_once(Itinerary& candidate) {
  const double kind = random_.fraction();
  const int arm = random_.below(kArmCount);
  const int legs = candidate.leg_count(arm);
  if (legs == 0) return;
  if (kind < kDropShare) {
    if (legs > 1) candidate.drop_rest(arm, random_.below(legs - 1));
  } else if (kind < kDropShare + kInsertShare) {
    candidate.insert_rest(arm, random_.below(legs), random_.in(systems_[arm]->range()));
  } else if (kind < kDropShare + kInsertShare + kWaitShare) {
    const int leg = random_.below(legs);
    const double changed_wait = candidate.wait(arm, leg) + random_.step() * duration_;
    candidate.set_wait(arm, leg, random_.chance(kNoWaitChance) ? 0.0 : std::max(0.0, changed_wait));
  } else {
    for (int mover = 0; mover < kArmCount; ++mover) {
      for (int leg = 0; leg + 1 < candidate.leg_count(mover); ++leg) {
        if (!random_.chance(kMoveChance)) continue;
        const double to = candidate.goal(mover, leg) + random_.step() * systems_[mover]->range().length();
        candidate.move_rest(mover, leg, to, kKept[random_.below(3)]);
      }
    }
  }
}

void Refinement::consider(const Itinerary& candidate) {
  // One arm always begins at once, unless both have to wait for an object that moves by itself.
  if (!improves_aligned(candidate) && proof_.settled_time() > 0.0) keep_if_faster(candidate);
}

void Refinement::keep_if_faster(const Itinerary& candidate) {
  const double duration = candidate.duration();
  if (duration >= duration_ * (1.0 - kWorthwhileGain)) return;
  ++evaluations_;
  if (!proves_for_good(candidate, duration)) return;
  best_ = candidate;
  duration_ = duration;
  waits_ = best_.waits_between();
}

bool Refinement::improves_aligned(Itinerary candidate) {
  const double shortest = std::max(candidate.busy_time(0), candidate.busy_time(1));
  const double waits = candidate.waits_between();
  double end = std::min(duration_, duration_ + kWaitWeight * (waits_ - waits) - kWorthwhileGain * duration_);
  if (shortest >= end) return false;
  int leader = random_.chance(kOtherLeaderChance) ? 1 - leader_ : leader_;
  if (!proven(candidate, leader, end)) {
    leader = 1 - leader;
    if (!proven(candidate, leader, end)) return false;
  }
  double too_short = shortest;
  if (proven(candidate, leader, shortest)) {
    end = shortest;
  } else {
    for (int i = 0; i < kBisections && !budget_.exhausted(); ++i) {
      const double middle = 0.5 * (too_short + end);
      (proven(candidate, leader, middle) ? end : too_short) = middle;
    }
  }
  candidate.align(leader, end);
  best_ = std::move(candidate);
  duration_ = best_.duration();
  waits_ = waits;
  leader_ = leader;
  return true;
}

bool Refinement::proven(Itinerary& candidate, int leader, double end) {
  ++evaluations_;
  candidate.align(leader, end);
  return proves_for_good(candidate, end);
}

bool Refinement::proves_for_good(const Itinerary& candidate, double end) const {
  return proof_.proves(candidate.tracks(), {0.0, std::max(end, proof_.settled_time())});
}

}  // namespace dualarm

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

/// How often a trial consists of one more change.
constexpr double kAnotherChange = 0.3;

/// Shares of the kinds of change; the rest of them moves the states between legs.
constexpr double kDropShare = 0.12;
constexpr double kInsertShare = 0.12;
constexpr double kWaitShare = 0.15;

/// How often a state is moved at all when states are moved, how often that sets an arm at rest in motion or brings one
/// in motion to rest, and how often a wait is dropped when waits are changed.
constexpr double kMoveChance = 0.6;
constexpr double kStartChance = 0.15;
constexpr double kStopChance = 0.15;
constexpr double kNoWaitChance = 0.5;
constexpr std::array kKept = {Keep::kWait, Keep::kNextStart, Keep::kNextArrival};

/// How often a new state is one at rest anywhere, instead of one that the arm passes already.
constexpr double kRestShare = 0.5;

/// How often the other order of the arms is tried first.
constexpr double kOtherLeaderChance = 0.1;

}  // namespace

Refinement::Refinement(const Systems& systems, const ClearanceProof& proof, Itinerary first, const PlanRules& rules,
                       Random& random, const Budget& budget)
    : systems_(systems),
      alignment_(proof, rules, budget),
      has_movers_(proof.settled_time() > 0.0),
      best_(std::move(first)),
      duration_(best_.duration()),
      waits_(best_.waits_between()),
      lower_bound_(rules.lower_bound),
      random_(random),
      budget_(budget) {}

void Refinement::run(int evaluation_limit, const std::function<void()>& on_better) {
  double told = duration_;
  const auto step = [&](const Itinerary& candidate) {
    consider(candidate);
    if (on_better && duration_ < told) on_better();
    told = duration_;
  };
  step(best_);
  while (evaluations() < evaluation_limit && duration_ > lower_bound_ * (1.0 + kWorthwhileGain) &&
         !budget_.exhausted()) {
    ++changes_;
    step(changed());
  }
}

Itinerary Refinement::changed() {
  Itinerary candidate = best_;
  do {
    change_once(candidate);
  } while (random_.chance(kAnotherChange) && !budget_.exhausted());
  return candidate;
}

void Refinement::change_once(Itinerary& candidate) {
  const double kind = random_.fraction();
  const int arm = random_.below(kArmCount);
  const int legs = candidate.leg_count(arm);
  if (legs == 0) return;
  if (kind < kDropShare) {
    if (legs > 1) candidate.drop_via(arm, random_.below(legs - 1));
  } else if (kind < kDropShare + kInsertShare) {
    insert(candidate, arm, random_.below(legs));
  } else if (kind < kDropShare + kInsertShare + kWaitShare) {
    const int leg = random_.below(legs);
    const double changed_wait = candidate.wait(arm, leg) + random_.step() * duration_;
    candidate.set_wait(arm, leg, random_.chance(kNoWaitChance) ? 0.0 : std::max(0.0, changed_wait));
  } else {
    move(candidate);
  }
}

void Refinement::insert(Itinerary& candidate, int arm, int leg) {
  JointState state = {random_.in(systems_[arm]->range()), 0.0};
  if (!random_.chance(kRestShare)) {
    const Profile& profile = candidate.profile(arm, leg);
    state = profile.at(random_.fraction() * profile.duration());
    state.velocity *= random_.fraction();
  }
  candidate.insert_via(arm, leg, state);
}

void Refinement::move(Itinerary& candidate) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (int leg = 0; leg + 1 < candidate.leg_count(arm); ++leg) {
      if (!random_.chance(kMoveChance)) continue;
      candidate.move_via(arm, leg, beside(arm, candidate.goal(arm, leg)), kKept[random_.below(3)]);
    }
  }
}

JointState Refinement::beside(int arm, JointState state) {
  state.position += random_.step() * systems_[arm]->range().length();
  if (state.velocity == 0.0) {
    if (random_.chance(kStartChance)) state.velocity = random_.step() * velocity_scale(*systems_[arm]);
  } else if (random_.chance(kStopChance)) {
    state.velocity = 0.0;
  } else {
    state.velocity += random_.step() * velocity_scale(*systems_[arm]);
  }
  return state;
}

void Refinement::consider(const Itinerary& candidate) {
  // One arm always begins at once, unless both have to wait for an object that moves by itself.
  if (!improves_aligned(candidate) && has_movers_) keep_if_faster(candidate);
}

void Refinement::keep_if_faster(Itinerary candidate) {
  const double duration = candidate.duration();
  if (duration >= duration_ * (1.0 - kWorthwhileGain)) return;
  if (alignment_.proves_as_is(candidate, duration)) take(std::move(candidate));
}

bool Refinement::improves_aligned(const Itinerary& candidate) {
  const double waits = candidate.waits_between();
  const double end = std::min(duration_, duration_ + kWaitWeight * (waits_ - waits) - kWorthwhileGain * duration_);
  if (std::max(candidate.busy_time(0), candidate.busy_time(1)) >= end) return false;
  const int leader = random_.chance(kOtherLeaderChance) ? 1 - leader_ : leader_;
  auto shorter = alignment_.shortest(candidate, leader, end);
  if (!shorter) return false;
  take(std::move(shorter->itinerary));
  leader_ = shorter->leader;
  return true;
}

void Refinement::take(Itinerary shorter) {
  best_ = std::move(shorter);
  duration_ = best_.duration();
  waits_ = best_.waits_between();
}

}  // namespace dualarm

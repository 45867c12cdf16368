#include "core/fallback/refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dualarm {
namespace {

/// Relative gain in duration below which a change is not worth a proof.
constexpr double kWorthwhileGain = 1e-5;

/// Relative difference of durations that are the same.
constexpr double kSameDuration = 1e-12;

/// What a second of waiting between legs counts against a second of duration: a plan that waits less at no cost in
/// duration is taken, because the other arm can often use the room.
constexpr double kWaitWeight = 0.1;

/// Halvings of the span between the shortest conceivable and the shortest proven duration of a changed plan.
constexpr int kBisections = 6;

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

/// rad/s: velocities drawn for arms without a limit.
constexpr double kWidestVelocity = 10.0;

double velocity_scale(const System& system) {
  const Interval limits = system.velocity();
  return std::min(kWidestVelocity, std::max(-limits.lower, limits.upper));
}

}  // namespace

Refinement::Refinement(const Systems& systems, const ClearanceProof& proof, Itinerary first,
                       const RefinementRules& rules, Random& random, const Budget& budget)
    : systems_(systems),
      proof_(proof),
      best_(std::move(first)),
      duration_(best_.duration()),
      waits_(best_.waits_between()),
      rules_(rules),
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
  while (evaluations_ < evaluation_limit && duration_ > rules_.lower_bound * (1.0 + kWorthwhileGain) &&
         !budget_.exhausted()) {
    ++evaluations_;
    step(changed());
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
  if (!improves_aligned(candidate) && proof_.settled_time() > 0.0) keep_if_faster(candidate);
}

void Refinement::keep_if_faster(Itinerary candidate) {
  const double duration = candidate.duration();
  if (duration >= duration_ * (1.0 - kWorthwhileGain)) return;
  if (!proven_as_is(candidate, duration)) return;
  best_ = std::move(candidate);
  duration_ = best_.duration();
  waits_ = best_.waits_between();
}

bool Refinement::improves_aligned(const Itinerary& candidate) {
  const double shortest = std::max(candidate.busy_time(0), candidate.busy_time(1));
  const double waits = candidate.waits_between();
  double end = std::min(duration_, duration_ + kWaitWeight * (waits_ - waits) - kWorthwhileGain * duration_);
  if (shortest >= end) return false;
  int leader = random_.chance(kOtherLeaderChance) ? 1 - leader_ : leader_;
  Itinerary shorter = candidate;
  if (!proven(shorter, leader, end)) {
    leader = 1 - leader;
    shorter = candidate;
    if (!proven(shorter, leader, end)) return false;
  }
  Itinerary trial = candidate;
  if (proven(trial, leader, shortest)) {
    shorter = std::move(trial);
  } else {
    double too_short = shortest;
    for (int i = 0; i < kBisections && !budget_.exhausted(); ++i) {
      const double middle = 0.5 * (too_short + end);
      trial = candidate;
      if (proven(trial, leader, middle)) {
        end = middle;
        shorter = std::move(trial);
      } else {
        too_short = middle;
      }
    }
  }
  best_ = std::move(shorter);
  duration_ = best_.duration();
  waits_ = best_.waits_between();
  leader_ = leader;
  return true;
}

bool Refinement::proven(Itinerary& candidate, int leader, double end) {
  candidate.align(leader, end);
  return proven_as_is(candidate, end);
}

bool Refinement::proven_as_is(Itinerary& candidate, double end) {
  ++evaluations_;
  if (!candidate.settle(end) || candidate.duration() > end * (1.0 + kSameDuration)) return false;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (candidate.first_start(arm) > rules_.max_start_delay) return false;
  }
  return proven_free(candidate);
}

/// Most plans collide where others have just done so, and to see that takes a tenth of a proof.
bool Refinement::proven_free(const Itinerary& candidate) {
  const std::array<Track, kArmCount> tracks = candidate.tracks();
  const double duration = candidate.duration();
  for (const double time : collisions_) {
    if (time < duration && proof_.collide_at(tracks, time)) return false;
  }
  const auto unproven = proof_.where_unproven(tracks, {0.0, duration});
  if (unproven) collisions_[next_collision_++ % collisions_.size()] = *unproven;
  return !unproven;
}

}  // namespace dualarm

#include "core/fallback/edge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dualarm {
namespace {

/// s: by how much a motion may end beside the edge's end and be said to end with it.
constexpr double kSameTime = 1e-11;

double duration_of(const std::vector<Profile>& motions) {
  double duration = 0.0;
  for (const Profile& motion : motions) duration += motion.duration();
  return duration;
}

/// Position and velocity of motions that follow each other, at a time of their common clock inside them.
JointState state_at(const std::vector<Profile>& motions, double time) {
  std::size_t current = 0;
  while (current + 1 < motions.size() && time > motions[current].duration()) time -= motions[current++].duration();
  return motions[current].at(time);
}

}  // namespace

std::optional<std::vector<Profile>> motions_of(const System& system, JointState from, const Move& move,
                                               const Budget& budget) {
  auto fastest = steer(system, from, move.target);
  if (!fastest) return std::nullopt;
  if (move.lasts < fastest->duration() - kSameTime) {
    auto part = cut(system, *fastest, move.lasts);
    if (!part) return std::nullopt;
    return std::vector<Profile>{std::move(*part)};
  }
  if (move.lasts > fastest->duration() + kSameTime) return stretched(system, from, move.target, move.lasts, budget);
  return std::vector<Profile>{std::move(*fastest)};
}

Attempt::Attempt(const Systems& systems, const ClearanceProof& proof, const JointStates& from, double time,
                 const JointStates& targets)
    : systems_(&systems), proof_(&proof), from_(from), time_(time), targets_(targets) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    can_wait_[arm] = can_hold(*systems[arm], from[arm]);
    can_stay_[arm] = can_hold(*systems[arm], targets[arm]);
    auto motion = steer(*systems[arm], from[arm], targets[arm]);
    if (!motion) return;
    tables_[arm].emplace_back(*motion);
    durations_[arm] = motion->duration();
    motions_[arm] = std::vector<Profile>{std::move(*motion)};
  }
}

bool Attempt::stretch(int arm, double duration) {
  auto slower = stretched(*(*systems_)[arm], from_[arm], targets_[arm], duration, proof_->budget());
  if (!slower) return false;
  tables_[arm].clear();
  for (const Profile& motion : *slower) tables_[arm].emplace_back(motion);
  durations_[arm] = duration_of(*slower);
  motions_[arm] = std::move(*slower);
  return true;
}

bool Attempt::can_do(int arm, double wait, double duration) const {
  const double arrival = wait + durations_[arm];
  return wait <= duration && (wait <= 0.0 || can_wait_[arm]) && (arrival + kSameTime >= duration || can_stay_[arm]);
}

std::optional<Edge> Attempt::edge(const JointPair& waits, double duration) const {
  if (!is_possible() || !(duration > 0.0)) return std::nullopt;
  Edge edge;
  edge.duration = duration;
  std::array<Track, kArmCount> tracks;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (!can_do(arm, waits[arm], duration)) return std::nullopt;
    const bool arrives = waits[arm] + durations_[arm] <= duration + kSameTime;
    edge.moves[arm] = {waits[arm], targets_[arm], arrives ? durations_[arm] : duration - waits[arm]};
    edge.end[arm] = arrives ? targets_[arm] : state_at(*motions_[arm], duration - waits[arm]);
    double begin = time_ + waits[arm];
    for (const ProfileTable& table : tables_[arm]) {
      tracks[arm].push_back({begin, &table});
      begin += table.duration();
    }
  }
  if (!proof_->proves(tracks, {time_, time_ + duration})) return std::nullopt;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (edge.moves[arm].lasts >= durations_[arm] || edge.moves[arm].lasts == 0.0) continue;
    if (motions_[arm]->size() > 1) return std::nullopt;
    const auto part = cut(*(*systems_)[arm], motions_[arm]->front(), edge.moves[arm].lasts);
    if (!part) return std::nullopt;
    edge.end[arm] = part->goal_state();
  }
  return edge;
}

std::optional<Edge> connect(const Systems& systems, const ClearanceProof& proof, const JointStates& from,
                            const JointStates& to, Interval time) {
  Attempt attempt(systems, proof, from, time.lower, to);
  if (!attempt.is_possible()) return std::nullopt;
  const double duration = std::max({attempt.duration(0), attempt.duration(1), time.length()});
  JointPair early = {};
  JointPair late = {};
  for (int arm = 0; arm < kArmCount; ++arm) {
    const double spare = duration - attempt.duration(arm);
    if (attempt.can_wait(arm)) late[arm] = spare;
    if (!attempt.can_stay(arm)) early[arm] = late[arm];
    const bool is_stuck = !attempt.can_wait(arm) && !attempt.can_stay(arm) && spare > kSameTime;
    if (is_stuck && !attempt.stretch(arm, duration)) return std::nullopt;
  }
  for (const JointPair& waits : {early, late}) {
    if (auto edge = attempt.edge(waits, duration)) return edge;
    if (late == early) break;
  }
  return std::nullopt;
}

}  // namespace dualarm

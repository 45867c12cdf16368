#include "core/fallback/itinerary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace dualarm {
namespace {

/// Part of a duration by which arms in motion at their goals may arrive apart: knots that are meant to share a time
/// have to (playback.h allows 1e-12).
constexpr double kSameTime = 5e-13;

/// rad: a step that is small for a robot, and of which a planner still sees that it is one.
constexpr double kFirstStep = 1e-3;

}  // namespace

Itinerary::Itinerary(const Systems& systems, const JointStates& start, const Arrivals& arrivals)
    : systems_(systems), start_(start), arrivals_(arrivals) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    standing_[arm] = motion_along(arm, start[arm], start[arm], Profile(*systems[arm], start[arm]));
  }
}

std::shared_ptr<const Itinerary::Motion> Itinerary::motion_along(int arm, JointState from, JointState to,
                                                                 const Profile& profile) const {
  return std::make_shared<const Motion>(
      Motion{from, to, profile, ProfileTable(profile), can_hold(*systems_[arm], from)});
}

std::optional<Itinerary::Leg> Itinerary::leg_between(int arm, double wait, JointState from, JointState to) const {
  const auto profile = steer(*systems_[arm], from, to);
  if (!profile) return std::nullopt;
  auto motion = motion_along(arm, from, to, *profile);
  return Leg{motion->may_wait ? wait : 0.0, std::move(motion)};
}

void Itinerary::append(int arm, double start_time, const Profile& profile, JointState goal) {
  if (profile.stands_still()) return;
  const double before = legs_[arm].empty() ? 0.0 : arrival(arm);
  const JointState from = legs_[arm].empty() ? start_[arm] : legs_[arm].back().motion->goal;
  auto motion = motion_along(arm, from, goal, profile);
  const double wait = motion->may_wait ? std::max(0.0, start_time - before) : 0.0;
  legs_[arm].push_back({wait, std::move(motion)});
}

bool Itinerary::move_via(int arm, int leg, JointState state, Keep keep) {
  auto& legs = legs_[arm];
  auto before = leg_between(arm, legs[leg].wait, legs[leg].motion->start, state);
  if (!before) return false;
  auto after = leg_between(arm, legs[leg + 1].wait, state, legs[leg + 1].motion->goal);
  if (!after) return false;
  double longer = 0.0;
  if (keep != Keep::kWait) longer += before->duration() - legs[leg].duration();
  if (keep == Keep::kNextArrival) longer += after->duration() - legs[leg + 1].duration();
  if (after->motion->may_wait) after->wait = std::max(0.0, after->wait - longer);
  legs[leg] = std::move(*before);
  legs[leg + 1] = std::move(*after);
  return true;
}

bool Itinerary::drop_via(int arm, int leg) {
  auto& legs = legs_[arm];
  auto joined =
      leg_between(arm, legs[leg].wait + legs[leg + 1].wait, legs[leg].motion->start, legs[leg + 1].motion->goal);
  if (!joined) return false;
  legs[leg] = std::move(*joined);
  legs.erase(legs.begin() + leg + 1);
  return true;
}

bool Itinerary::insert_via(int arm, int leg, JointState state) {
  auto& legs = legs_[arm];
  auto before = leg_between(arm, legs[leg].wait, legs[leg].motion->start, state);
  if (!before) return false;
  auto after = leg_between(arm, 0.0, state, legs[leg].motion->goal);
  if (!after) return false;
  legs[leg] = std::move(*before);
  legs.insert(legs.begin() + leg + 1, std::move(*after));
  return true;
}

void Itinerary::set_wait(int arm, int leg, double wait) {
  if (may_wait(arm, leg)) legs_[arm][leg].wait = wait;
}

double Itinerary::busy_time(int arm) const {
  if (legs_[arm].empty()) return 0.0;
  return arrival(arm) - legs_[arm].front().wait;
}

double Itinerary::arrival(int arm) const {
  return std::accumulate(legs_[arm].begin(), legs_[arm].end(), 0.0,
                         [](double sum, const Leg& leg) { return sum + leg.wait + leg.duration(); });
}

double Itinerary::waits_between() const {
  double sum = 0.0;
  for (const auto& legs : legs_) {
    for (std::size_t leg = 1; leg < legs.size(); ++leg) sum += legs[leg].wait;
  }
  return sum;
}

double Itinerary::duration() const { return std::max(arrival(0), arrival(1)); }

double Itinerary::first_start(int arm) const { return legs_[arm].empty() ? 0.0 : legs_[arm].front().wait; }

void Itinerary::align(int leader, double end) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    auto& legs = legs_[arm];
    if (legs.empty()) continue;
    if (arm == leader) {
      legs.front().wait = 0.0;
      continue;
    }
    const auto rest = std::find_if(legs.begin(), legs.end(), [](const Leg& leg) { return leg.motion->may_wait; });
    if (rest != legs.end()) rest->wait = std::max(0.0, rest->wait + end - arrival(arm));
  }
}

bool Itinerary::settle(double end, const Budget& budget) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (legs_[arm].empty()) {
      const bool stays = start_[arm].velocity == 0.0 || end == 0.0;
      if (!stays || arrivals_.earliest[arm] > 0.0) return false;
      continue;
    }
    const double late = arrival(arm);
    if (legs_[arm].back().motion->goal.velocity == 0.0) {
      if (late < arrivals_.earliest[arm] && !delay(arm, arrivals_.earliest[arm] - late, budget)) return false;
    } else if (std::abs(end - late) > kSameTime * end && !(end > late && delay(arm, end - late, budget))) {
      return false;
    }
  }
  return true;
}

/// Where the arm last rests, or else by a slower last leg.
bool Itinerary::delay(int arm, double by, const Budget& budget) {
  auto& legs = legs_[arm];
  const auto rest = std::find_if(legs.rbegin(), legs.rend(), [](const Leg& leg) { return leg.motion->may_wait; });
  if (rest != legs.rend()) {
    rest->wait += by;
    return true;
  }
  const auto last = legs.back().motion;
  const auto slower = stretched(*systems_[arm], last->start, last->goal, legs.back().duration() + by, budget);
  if (!slower) return false;
  legs.pop_back();
  for (const Profile& profile : *slower) {
    const JointState from = legs.empty() ? start_[arm] : legs.back().motion->goal;
    const JointState to = &profile == &slower->back() ? last->goal : profile.goal_state();
    legs.push_back({0.0, motion_along(arm, from, to, profile)});
  }
  return true;
}

bool Itinerary::leave_by(int arm, double latest) {
  auto& legs = legs_[arm];
  if (legs.empty() || legs.front().wait <= latest) return true;
  const double before = legs.front().wait + legs.front().duration();
  const JointState from = start(arm, 0);
  const double way = goal(arm, 0).position - from.position;
  const bool has_stepped = legs.size() > 1 && std::abs(way) < 1.5 * kFirstStep;  // or as much, to rounding
  if (!has_stepped) {
    const double step = std::copysign(std::min(kFirstStep, 0.5 * std::abs(way)), way);
    if (!insert_via(arm, 0, {from.position + step, 0.0})) return false;
  }
  if (!legs[1].motion->may_wait) return false;
  const double after = latest + legs[0].duration() + (has_stepped ? 0.0 : legs[1].duration());
  legs[0].wait = latest;
  legs[1].wait = std::max(0.0, legs[1].wait + before - after);
  return true;
}

std::array<Track, kArmCount> Itinerary::tracks() const {
  std::array<Track, kArmCount> tracks;
  for (int arm = 0; arm < kArmCount; ++arm) {
    double time = 0.0;
    for (const Leg& leg : legs_[arm]) {
      time += leg.wait;
      tracks[arm].push_back({time, &leg.motion->table});
      time += leg.duration();
    }
    if (tracks[arm].empty()) tracks[arm].push_back({0.0, &standing_[arm]->table});
  }
  return tracks;
}

Schedule Itinerary::schedule() const {
  Schedule schedule;
  for (int arm = 0; arm < kArmCount; ++arm) {
    double time = 0.0;
    for (const Leg& leg : legs_[arm]) {
      time += leg.wait;
      schedule[arm].push_back({time, leg.motion->profile});
      time += leg.motion->profile.duration();
    }
    if (schedule[arm].empty()) schedule[arm].push_back({0.0, standing_[arm]->profile});
  }
  return schedule;
}

}  // namespace dualarm

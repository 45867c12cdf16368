#include "core/fallback/itinerary.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace dualarm {

Itinerary::Itinerary(const Systems& systems, const JointPair& start)
    : systems_(systems),
      standing_{*leg_between(0, 0.0, start[0], start[0]), *leg_between(1, 0.0, start[1], start[1])} {}

std::optional<Itinerary::Leg> Itinerary::leg_between(int arm, double wait, double from, double to) const {
  auto profile = steer(*systems_[arm], from, to);
  if (!profile) return std::nullopt;
  ProfileTable table(*profile);
  return Leg{wait, from, to, std::move(*profile), std::move(table)};
}

bool Itinerary::append(int arm, double start_time, double goal) {
  auto& legs = legs_[arm];
  const double from = legs.empty() ? standing_[arm].goal : legs.back().goal;
  if (from == goal) return true;
  double free_from = 0.0;
  for (const Leg& leg : legs) free_from += leg.wait + leg.table.duration();
  auto leg = leg_between(arm, std::max(0.0, start_time - free_from), from, goal);
  if (leg) legs.push_back(std::move(*leg));
  return leg.has_value();
}

bool Itinerary::move_rest(int arm, int leg, double position, Keep keep) {
  auto& legs = legs_[arm];
  auto before = leg_between(arm, legs[leg].wait, legs[leg].start, position);
  auto after = leg_between(arm, legs[leg + 1].wait, position, legs[leg + 1].goal);
  if (!before || !after) return false;
  double longer = 0.0;
  if (keep != Keep::kWait) longer += before->table.duration() - legs[leg].table.duration();
  if (keep == Keep::kNextArrival) longer += after->table.duration() - legs[leg + 1].table.duration();
  after->wait = std::max(0.0, after->wait - longer);
  legs[leg] = std::move(*before);
  legs[leg + 1] = std::move(*after);
  return true;
}

bool Itinerary::drop_rest(int arm, int leg) {
  auto& legs = legs_[arm];
  auto joined = leg_between(arm, legs[leg].wait + legs[leg + 1].wait, legs[leg].start, legs[leg + 1].goal);
  if (!joined) return false;
  legs[leg] = std::move(*joined);
  legs.erase(legs.begin() + leg + 1);
  return true;
}

bool Itinerary::insert_rest(int arm, int leg, double position) {
  auto& legs = legs_[arm];
  auto before = leg_between(arm, legs[leg].wait, legs[leg].start, position);
  auto after = leg_between(arm, 0.0, position, legs[leg].goal);
  if (!before || !after) return false;
  legs[leg] = std::move(*before);
  legs.insert(legs.begin() + leg + 1, std::move(*after));
  return true;
}

double Itinerary::busy_time(int arm) const {
  if (legs_[arm].empty()) return 0.0;
  return std::accumulate(legs_[arm].begin(), legs_[arm].end(), -legs_[arm].front().wait,
                         [](double sum, const Leg& leg) { return sum + leg.wait + leg.table.duration(); });
}

double Itinerary::waits_between() const {
  double sum = 0.0;
  for (const auto& legs : legs_) {
    for (std::size_t leg = 1; leg < legs.size(); ++leg) sum += legs[leg].wait;
  }
  return sum;
}

double Itinerary::duration() const {
  double last = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (!legs_[arm].empty()) last = std::max(last, legs_[arm].front().wait + busy_time(arm));
  }
  return last;
}

void Itinerary::align(int leader, double end) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (legs_[arm].empty()) continue;
    legs_[arm].front().wait = arm == leader ? 0.0 : std::max(0.0, end - busy_time(arm));
  }
}

std::array<Track, kArmCount> Itinerary::tracks() const {
  std::array<Track, kArmCount> tracks;
  for (int arm = 0; arm < kArmCount; ++arm) {
    double time = 0.0;
    for (const Leg& leg : legs_[arm]) {
      time += leg.wait;
      tracks[arm].push_back({time, &leg.table});
      time += leg.table.duration();
    }
    if (tracks[arm].empty()) tracks[arm].push_back({0.0, &standing_[arm].table});
  }
  return tracks;
}

Schedule Itinerary::schedule() const {
  Schedule schedule;
  for (int arm = 0; arm < kArmCount; ++arm) {
    double time = 0.0;
    for (const Leg& leg : legs_[arm]) {
      time += leg.wait;
      schedule[arm].push_back({time, leg.profile});
      time += leg.profile.duration();
    }
    if (schedule[arm].empty()) schedule[arm].push_back({0.0, standing_[arm].profile});
  }
  return schedule;
}

}  // namespace dualarm

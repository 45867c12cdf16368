#include "core/fallback/known_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dualarm {
namespace {

/// Part of a motion's time by which steering may miss it and still have made the same motion: what quadratures leave.
constexpr double kSameTime = 1e-9;

/// By which parts of its duration a plan is made longer until it is proven: exact plans touch what they keep clear of,
/// and first-order proofs need some room.
constexpr std::array kLonger = {0.0, 1e-4, 1e-3, 1e-2, 5e-2};

}  // namespace

std::vector<Profile> fastest_parts(const System& system, const Profile& motion) {
  const std::vector<Arc>& arcs = motion.arcs();
  std::vector<Profile> parts;
  for (auto first = arcs.begin(); first != arcs.end();) {
    auto end = arcs.end();
    const auto is_fastest = [&] {
      const double time = (end - 1)->end_time - first->start_time;
      return std::abs(steering_time(system, first->start, (end - 1)->end) - time) <= kSameTime * motion.duration();
    };
    while (end != first + 1 && !is_fastest()) --end;
    parts.emplace_back(system, std::vector<Arc>(first, end));
    first = end;
  }
  return parts;
}

Itinerary itinerary_of(const Systems& systems, const JointStates& start, const JointStates& goal,
                       const Arrivals& arrivals, const Schedule& schedule) {
  Itinerary itinerary(systems, start, arrivals);
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (const TimedProfile& timed : schedule[arm]) {
      double time = timed.start_time;
      const std::vector<Profile> parts = fastest_parts(*systems[arm], timed.profile);
      for (const Profile& part : parts) {
        const bool is_last = &timed == &schedule[arm].back() && &part == &parts.back();
        itinerary.append(arm, time, part, is_last ? goal[arm] : part.goal_state());
        time += part.duration();
      }
    }
  }
  return itinerary;
}

std::optional<Itinerary> proven_free(const ClearanceProof& proof, const Itinerary& itinerary, double max_start_delay) {
  const int leader = itinerary.first_start(0) <= itinerary.first_start(1) ? 0 : 1;
  for (const double longer : kLonger) {
    Itinerary later = itinerary;
    const double end = (1.0 + longer) * itinerary.duration();
    if (longer > 0.0) later.align(leader, end);
    if (!later.settle(end, proof.budget()) || !later.leave_by(0, max_start_delay) ||
        !later.leave_by(1, max_start_delay)) {
      continue;
    }
    if (proof.proves(later.tracks(), {0.0, later.duration()})) return later;
  }
  return std::nullopt;
}

}  // namespace dualarm

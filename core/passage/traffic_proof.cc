#include "core/passage/traffic_proof.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "core/passage/relaxed_arm.h"
#include "core/passage/through.h"
#include "core/passage/traffic_obstacle.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

/// Part by which a bound is lowered for what roots and quadratures leave.
constexpr double kRounding = 1e-10;
/// Positions between start and goal at which obstacles are sought.
constexpr int kPositions = 8;

bool turns(const TrackedBody& object) {
  const auto& segments = object.track->segments();
  return std::any_of(segments.begin(), segments.end(), [](const PoseTrack::Segment& s) { return s.angle != 0.0; });
}

/// Those whose slices are exact: a bound must not count a gap as closed.
std::vector<TrackedBody> exact_objects(const Problem& problem) {
  std::vector<TrackedBody> objects = tracked_bodies(problem);
  std::erase_if(objects, turns);
  return objects;
}

/// One arm among moving objects.
class Way {
 public:
  Way(const Problem& problem, int arm, const Arm& relaxed)
      : arm_(arm),
        task_(problem.tasks[arm]),
        direction_(task_.goal.position < task_.start.position ? -1 : 1),
        system_(relaxed),
        complete_(complete_until(relaxed)) {
    const auto motion = fastest_motion(system_, task_.start, task_.goal, Swings::kSkip);
    if (const auto* fastest = std::get_if<FastestMotion>(&motion)) {
      traveller_ = {&system_, task_.start, task_.goal, fastest->profile};
    }
  }
  Way(const Way&) = delete;  // The traveller points at the system.
  Way& operator=(const Way&) = delete;

  bool exists() const { return traveller_ && task_.start.position != task_.goal.position; }

  /// What an obstacle demands, as far as it was looked at.
  TrafficProof demand_of(const TrafficObstacle& obstacle) const {
    TrafficProof most;
    for (int i = 1; i <= kPositions; ++i) {
      const double share = static_cast<double>(i) / kPositions;
      const double position = task_.start.position + share * (task_.goal.position - task_.start.position);
      for (const Interval& times : obstacle.times_at(position)) {
        const Meeting seed = {position, std::min(0.5 * (times.lower + times.upper), times.lower + 1.0)};
        if (most.until >= seed.time || !is_too_late(obstacle, seed)) continue;
        const TrafficProof found = behind(obstacle, seed);
        if (found.duration > most.duration) most = found;
      }
    }
    return most;
  }

 private:
  double ahead(double position) const { return direction_ * (position - task_.start.position); }  ///< rad, of the start

  /// Whether an obstacle has a point at or beyond which the arm cannot be in time: then it is behind all of it.
  bool is_too_late(const TrafficObstacle& obstacle, const Meeting& seed) const {
    const auto comes_too_late = [this](const Meeting& meeting) {
      return ahead(meeting.position) > 0.0 && meeting.time < earliest(meeting.position);
    };
    return comes_too_late(obstacle.follow(seed, -1, direction_, comes_too_late));
  }

  /// The slowest of the meetings that lead from the seed back towards the start as the obstacle goes on.
  TrafficProof behind(const TrafficObstacle& obstacle, const Meeting& seed) const {
    TrafficProof slowest;
    obstacle.follow(seed, 1, -direction_, [&](const Meeting& meeting) {
      const double beyond = direction_ * (meeting.position - task_.goal.position);
      if (ahead(meeting.position) <= 0.0) return true;
      if (beyond > 0.0) return false;
      const double duration = meeting.time + remaining(meeting.position);
      if (duration > slowest.duration) slowest = {duration, arm_, meeting.position, meeting.time};
      return false;
    });
    return slowest;
  }

  /// No motion gets to a position sooner, or from there to the goal in less time, s.
  double earliest(double position) const {
    const Through early(*traveller_, position, Hurry::kEarlyArrival);
    return early.exists() ? std::min(early.most().before, complete_) : 0.0;
  }
  double remaining(double position) const {
    const Through late(*traveller_, position, Hurry::kLateDeparture);
    return late.exists() ? std::min(late.most().after, complete_) : 0.0;
  }

  int arm_;
  Task task_;
  int direction_;  ///< of the goal, seen from the start
  SingleJointArm system_;
  double complete_;  ///< s
  std::optional<Traveller> traveller_;
};

}  // namespace

std::optional<TrafficProof> traffic_proof(const Problem& problem, double clearance, double known, double longest,
                                          const Budget& budget) {
  std::optional<TrafficProof> best;
  const std::vector<TrackedBody> objects = exact_objects(problem);
  for (int arm = 0; arm < kArmCount && !objects.empty(); ++arm) {
    // One that is in motion at its goal is expected nowhere afterwards: an object may come round behind its curve.
    if (problem.tasks[arm].goal.velocity != 0.0) continue;
    const auto relaxed = relaxed_arm(loaded_arm(problem, arm), problem.tasks[arm], longest);
    if (!relaxed) continue;
    const Way way(problem, arm, *relaxed);
    if (!way.exists()) continue;
    for (const TrackedBody& object : objects) {
      TrafficProof found = way.demand_of(TrafficObstacle(problem, arm, object, clearance, budget));
      if (budget.exhausted()) return std::nullopt;
      found.duration = std::min(found.duration * (1.0 - kRounding), longest);
      if (found.duration > (best ? best->duration : known)) best = found;
    }
  }
  return best;
}

}  // namespace dualarm

#include "core/fallback/clearance_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"

namespace dualarm {
namespace {

/// Joint error (rad) of a ProfileTable that a proof allows for; tests/core/fallback measures it far below.
constexpr double kTableError = 1e-6;

/// Distance queries after which a motion counts as too close to be worth a proof. A motion that passes at 1 mm with
/// 20 m/s takes some 300.
constexpr int kQueryLimit = 1500;

double distance_bound(const Shape& first, const Shape& second) {
  return clearance(first, second).distance - clearance_error(first, second);
}

double position_on(const Track& track, double time) {
  auto motion = track.begin();
  while (motion + 1 != track.end() && (motion + 1)->start_time <= time) ++motion;
  return motion->table->position(time - motion->start_time);
}

/// Times between which no arm turns back, starts or stops, ascending.
std::vector<double> breakpoints(const std::array<Track, kArmCount>& tracks) {
  std::vector<double> times;
  for (const Track& track : tracks) {
    for (const TimedTable& motion : track) {
      times.push_back(motion.start_time);
      for (const double turn : motion.table->turning_times()) times.push_back(motion.start_time + turn);
      times.push_back(motion.start_time + motion.table->duration());
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

ClearanceProof::ClearanceProof(const Problem& problem, double clearance)
    : fixed_(fixed_bodies(problem)), clearance_(clearance) {
  for (int arm = 0; arm < kArmCount; ++arm) {
    bases_[arm] = problem.arms[arm].base;
    moving_[arm] = moving_bodies(problem, arm);
    reach_[arm] = 0.0;
    for (const Body& body : moving_[arm]) reach_[arm] = std::max(reach_[arm], reach(body.shape));
  }
}

double ClearanceProof::slack(const JointPair& positions) const {
  std::array<std::vector<Shape>, kArmCount> placed_bodies;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Eigen::Isometry3d pose = link_pose(bases_[arm], positions[arm]);
    for (const Body& body : moving_[arm]) placed_bodies[arm].push_back(placed(body.shape, pose));
  }
  double closest = std::numeric_limits<double>::infinity();
  for (const Shape& first : placed_bodies[0]) {
    for (const Shape& second : placed_bodies[1]) closest = std::min(closest, distance_bound(first, second));
  }
  for (const Body& obstacle : fixed_) {
    for (const auto& bodies : placed_bodies) {
      for (const Shape& body : bodies) closest = std::min(closest, distance_bound(body, obstacle.shape));
    }
  }
  return closest - clearance_ - kTableError * (reach_[0] + reach_[1]);
}

double ClearanceProof::largest_approach(const JointPair& from, const JointPair& to) const {
  return reach_[0] * std::abs(to[0] - from[0]) + reach_[1] * std::abs(to[1] - from[1]);
}

/// A span of time in which both joints move one way, and what is known at its ends.
struct ClearanceProof::Span {
  struct End {
    double time;
    JointPair positions;
    double slack;
  };
  End from;
  End to;
};

bool ClearanceProof::proves(const std::array<Track, kArmCount>& tracks) const {
  int queries = 0;
  const auto look = [&](double time) -> Span::End {
    ++queries;
    const JointPair positions = {position_on(tracks[0], time), position_on(tracks[1], time)};
    return {time, positions, slack(positions)};
  };
  std::vector<Span> open;
  std::vector<Span::End> ends;
  for (const double time : breakpoints(tracks)) {
    ends.push_back(look(time));
    if (ends.back().slack <= 0.0) return false;
    if (ends.size() > 1) open.push_back({*(ends.end() - 2), ends.back()});
  }
  // Width first: a collision somewhere is met before much has been proven elsewhere.
  for (std::vector<Span> halves; !open.empty(); open.swap(halves)) {
    halves.clear();
    for (const Span& span : open) {
      const double approach = largest_approach(span.from.positions, span.to.positions);
      if (span.from.slack + span.to.slack > approach) continue;
      const Span::End middle = look(0.5 * (span.from.time + span.to.time));
      if (middle.slack <= 0.0 || queries > kQueryLimit) return false;
      halves.push_back({span.from, middle});
      halves.push_back({middle, span.to});
    }
  }
  return true;
}

}  // namespace dualarm

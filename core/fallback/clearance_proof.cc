#include "core/fallback/clearance_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Joint error (rad) of a ProfileTable that a proof allows for; tests/core/fallback measures it far below.
constexpr double kTableError = 1e-6;

/// Looks at a pair of bodies after which a motion counts as too close to be worth a proof. A motion that passes at 1 mm
/// with 20 m/s takes some 300.
constexpr int kLookLimit = 1500;

/// Looks after which the budget is asked again: some hundredths of a millisecond.
constexpr int kLooksBetweenPolls = 64;

/// s. How exactly it is known when an object has left a place for good.
constexpr double kLeaveError = 1e-4;

/// m. What rounding of coordinates of up to 10 km costs a bounding ball or box.
constexpr double kRounding = 1e-10;

double position_on(const Track& track, double time) {
  auto motion = track.begin();
  while (motion + 1 != track.end() && (motion + 1)->start_time <= time) ++motion;
  return motion->table->position(time - motion->start_time);
}

/// Times of an interval between which no arm turns back, starts or stops, ascending, with its ends.
std::vector<double> breakpoints(const std::array<Track, kArmCount>& tracks, Interval interval) {
  std::vector<double> times = {interval.lower, interval.upper};
  const auto add = [&](double time) {
    if (time > interval.lower && time < interval.upper) times.push_back(time);
  };
  for (const Track& track : tracks) {
    for (const TimedTable& motion : track) {
      add(motion.start_time);
      for (const double turn : motion.table->turning_times()) add(motion.start_time + turn);
      add(motion.start_time + motion.table->duration());
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Eigen::AlignedBox3d grown(Eigen::AlignedBox3d box, const Eigen::Vector3d& by) {
  box.min() -= by;
  box.max() += by;
  return box;
}

/// What a body of an arm may sweep, wherever the joint is.
Eigen::AlignedBox3d swept_by(const Base& base, const Shape& in_link, double reach) {
  const double low = farthest_point(in_link, -Eigen::Vector3d::UnitZ()).z();
  const double high = farthest_point(in_link, Eigen::Vector3d::UnitZ()).z();
  return {base.position + Eigen::Vector3d(-reach, -reach, low), base.position + Eigen::Vector3d(reach, reach, high)};
}

Eigen::AlignedBox3d swept_along(const PoseTrack& track, double extent) {
  Eigen::AlignedBox3d box;
  for (const TimedPose& timed : track.poses()) box.extend(timed.pose.translation());
  return grown(box, Eigen::Vector3d::Constant(extent));
}

}  // namespace

/// Where everything is at a time.
struct ClearanceProof::Instant {
  double time;  ///< s
  JointPair positions;
  std::array<Eigen::Isometry3d, kArmCount> links;
};

/// A span of time in which both joints move one way, and what is known of a pair at its ends.
struct ClearanceProof::Span {
  const Pair* pair;
  Instant from;
  Instant to;
  double slack_from;
  double slack_to;
};

ClearanceProof::ClearanceProof(const Problem& problem, double clearance, const Budget& budget)
    : bases_{problem.arms[0].base, problem.arms[1].base}, settled_time_(-kInfinity), budget_(&budget) {
  for (const TrackedBody& tracked : tracked_bodies(problem)) {
    settled_time_ = std::max(settled_time_, tracked.track->end_time());
  }
  movers_ = movers_of(problem);
  const auto swing_of_arm = [](const Mover& mover) { return mover.arm >= 0 ? mover.swing : 0.0; };
  for (std::size_t i = 0; i < movers_.size() && movers_[i].arm >= 0; ++i) {
    for (std::size_t j = i + 1; j < movers_.size(); ++j) {
      const Mover& first = movers_[i];
      const Mover& second = movers_[j];
      if (first.arm == second.arm) continue;
      const double margin =
          clearance + clearance_error(first.shape, second.shape) + kTableError * (first.swing + swing_of_arm(second));
      if (first.where.exteriorDistance(second.where) <= margin + kRounding) pairs_.push_back({i, j, margin});
    }
  }
}

/// Arms come first.
std::vector<ClearanceProof::Mover> ClearanceProof::movers_of(const Problem& problem) const {
  std::vector<Mover> movers;
  const auto add = [&](const Shape& shape, double swing) -> Mover& {
    movers.push_back({shape, dualarm::centre(shape), bounding_radius(shape), swing});
    return movers.back();
  };
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (const Body& body : moving_bodies(problem, arm)) {
      Mover& mover = add(body.shape, reach(body.shape));
      mover.arm = arm;
      mover.where = swept_by(bases_[arm], body.shape, mover.swing);
    }
  }
  for (const TrackedBody& tracked : tracked_bodies(problem)) {
    Mover& mover = add(tracked.body.shape, extent(tracked.body.shape));
    mover.track = tracked.track;
    mover.where = swept_along(*tracked.track, mover.swing);
  }
  for (const Body& body : fixed_bodies(problem)) {
    Mover& mover = add(body.shape, 0.0);
    mover.where = grown(Eigen::AlignedBox3d(mover.centre), Eigen::Vector3d::Constant(mover.radius));
  }
  return movers;
}

ClearanceProof::Instant ClearanceProof::instant(const JointPair& positions, double time) const {
  return {time, positions, {link_pose(bases_[0], positions[0]), link_pose(bases_[1], positions[1])}};
}

Eigen::Isometry3d ClearanceProof::pose(const Mover& mover, const Instant& instant) const {
  if (mover.arm >= 0) return instant.links[mover.arm];
  return mover.track != nullptr ? mover.track->pose_at(instant.time) : Eigen::Isometry3d::Identity();
}

Eigen::Vector3d ClearanceProof::centre(const Mover& mover, const Instant& instant) const {
  if (mover.arm < 0 && mover.track == nullptr) return mover.centre;
  return pose(mover, instant) * mover.centre;
}

/// What balls around bodies tell of the slack, quickly.
double ClearanceProof::far_slack(const Pair& pair, const Instant& instant) const {
  const Mover& first = movers_[pair.first];
  const Mover& second = movers_[pair.second];
  const Eigen::Vector3d seen_by_first = instant.links[first.arm].inverse() * centre(second, instant);
  return distance_to_ball(first.shape, seen_by_first, second.radius) - pair.margin - kRounding;
}

double ClearanceProof::slack(const Pair& pair, const Instant& instant) const {
  const Mover& first = movers_[pair.first];
  const Mover& second = movers_[pair.second];
  return clearance(placed(first.shape, pose(first, instant)), placed(second.shape, pose(second, instant))).distance -
         pair.margin;
}

double ClearanceProof::slack(const JointPair& positions) const {
  const Instant now = instant(positions, 0.0);
  double closest = kInfinity;
  for (const Pair& pair : pairs_) {
    if (movers_[pair.second].track != nullptr || far_slack(pair, now) >= closest) continue;
    closest = std::min(closest, slack(pair, now));
  }
  return closest;
}

/// Largest way (m) that the two bodies can have moved against each other, when the joints changed monotonely.
double ClearanceProof::approach(const Pair& pair, const Instant& from, const Instant& to) const {
  double way = 0.0;
  for (const Mover* mover : {&movers_[pair.first], &movers_[pair.second]}) {
    if (mover->arm >= 0) way += mover->swing * std::abs(to.positions[mover->arm] - from.positions[mover->arm]);
    if (mover->track == nullptr) continue;
    const Interval between = {from.time, to.time};
    way += mover->track->travel(between) + mover->swing * mover->track->turn(between);
  }
  return way;
}

bool ClearanceProof::collide_at(const std::array<Track, kArmCount>& tracks, double time) const {
  const Instant now = instant({position_on(tracks[0], time), position_on(tracks[1], time)}, time);
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const Pair& pair) { return far_slack(pair, now) <= 0.0 && slack(pair, now) <= 0.0; });
}

std::optional<double> ClearanceProof::where_unproven(const std::array<Track, kArmCount>& tracks, Interval time) const {
  if (budget_->exhausted()) return time.lower;
  std::vector<Instant> instants;
  for (const double at : breakpoints(tracks, time)) {
    instants.push_back(instant({position_on(tracks[0], at), position_on(tracks[1], at)}, at));
  }
  std::vector<Span> open;
  for (const Pair& pair : pairs_) {
    std::optional<double> known;  // the slack where the last span ended
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      const Instant& from = instants[i];
      const Instant& to = instants[i + 1];
      const double way = approach(pair, from, to);
      if (far_slack(pair, from) + far_slack(pair, to) > way) {
        known.reset();
        continue;
      }
      const double slack_from = known ? *known : slack(pair, from);
      const double slack_to = slack(pair, to);
      if (slack_from <= 0.0) return from.time;
      if (slack_to <= 0.0) return to.time;
      if (slack_from + slack_to <= way) open.push_back({&pair, from, to, slack_from, slack_to});
      known = slack_to;
    }
  }
  return halve(open, tracks, static_cast<int>(instants.size()));
}

/// Width first: a collision somewhere is met before much has been proven elsewhere.
std::optional<double> ClearanceProof::halve(std::vector<Span>& open, const std::array<Track, kArmCount>& tracks,
                                            int looks) const {
  for (std::vector<Span> halves; !open.empty(); open.swap(halves)) {
    halves.clear();
    for (const Span& span : open) {
      const double time = 0.5 * (span.from.time + span.to.time);
      const Instant middle = instant({position_on(tracks[0], time), position_on(tracks[1], time)}, time);
      const double slack_there = slack(*span.pair, middle);
      if (slack_there <= 0.0 || ++looks > kLookLimit) return time;
      if (looks % kLooksBetweenPolls == 0 && budget_->exhausted()) return time;
      const auto keep = [&](const Instant& from, const Instant& to, double slack_from, double slack_to) {
        if (slack_from + slack_to > approach(*span.pair, from, to)) return;
        halves.push_back({span.pair, from, to, slack_from, slack_to});
      };
      keep(span.from, middle, span.slack_from, slack_there);
      keep(middle, span.to, slack_there, span.slack_to);
    }
  }
  return std::nullopt;
}

double ClearanceProof::free_from(int arm, double position) const {
  double latest = -kInfinity;
  for (const Pair& pair : pairs_) {
    if (movers_[pair.first].arm != arm || movers_[pair.second].track == nullptr) continue;
    JointPair positions = {};
    positions[arm] = position;
    const Instant begin = instant(positions, 0.0);
    const Instant end = instant(positions, std::max(0.0, movers_[pair.second].track->end_time()));
    if (slack(pair, end) <= 0.0) return kInfinity;
    latest = std::max(latest, last_unproven(pair, begin, end));
  }
  return latest;
}

/// The end (s) of the last stretch of time in which an arm that stands is not proven free; minus infinity for none.
double ClearanceProof::last_unproven(const Pair& pair, const Instant& from, const Instant& to) const {
  if (slack(pair, from) + slack(pair, to) > approach(pair, from, to)) return -kInfinity;
  if (to.time - from.time <= kLeaveError || budget_->exhausted()) return to.time;
  const Instant middle = instant(from.positions, 0.5 * (from.time + to.time));
  const double late = last_unproven(pair, middle, to);
  return late > -kInfinity ? late : last_unproven(pair, from, middle);
}

}  // namespace dualarm

// Start times with moving objects against a scan of all pairs of start times that samples distances.
#include "core/coordination/moving_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/coordination/diagram.h"
#include "core/coordination/start_times.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "tests/core/coordination/random_traffic.h"
#include "tests/core/coordination/sampled_traffic.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;
/// Steps of the scan, of the longer motion.
constexpr int kSteps = 40;

using Scene = TrafficScene;

std::optional<IntervalSet> starts_of(const Scene& scene, int arm) {
  return forbidden_starts(scene.motions[arm], scene.problem.arms[arm].base, moving_bodies(scene.problem, arm),
                          tracked_bodies(scene.problem), scene.problem.options.clearance, Budget());
}

/// All pairs of start times on a grid of time.
class Scan {
 public:
  explicit Scan(const Scene& scene) : scene_(scene), sampled_(scene), step_(scene.longest() / kSteps) {
    const double last = scene.end_of_tracks() + scene.longest();
    count_ = static_cast<int>(last / step_) + 2;
    for (int arm = 0; arm < kArmCount; ++arm) {
      own_[arm] = static_cast<int>(std::ceil(scene.motions[arm].duration() / step_));
      for (int start = 0; start < count_; ++start) hits_[arm].push_back(is_hit(arm, start));
    }
  }

  double step() const { return step_; }
  int count() const { return count_; }
  bool hits(int arm, int start) const { return hits_[arm][start]; }

  /// The pair of least duration (s) in which nothing is seen to collide.
  struct Pair {
    int first;
    int second;
    double duration;
  };
  std::optional<Pair> best() {
    std::optional<Pair> best;
    for (int first = 0; first < count_; ++first) {
      for (int second = 0; second < count_; ++second) {
        const double duration =
            std::max(first * step_ + scene_.motions[0].duration(), second * step_ + scene_.motions[1].duration());
        if ((best && duration >= best->duration) || hits_[0][first] || hits_[1][second]) continue;
        if (arms_collide(second - first)) continue;
        best = {first, second, duration};
      }
    }
    return best;
  }

  /// A closer look has found what the scan missed.
  void blame(const Pair& pair, Culprit culprit) {
    if (culprit == Culprit::kFirst) hits_[0][pair.first] = true;
    if (culprit == Culprit::kSecond) hits_[1][pair.second] = true;
    if (culprit == Culprit::kBoth) delays_[pair.second - pair.first] = true;
  }

  bool arms_collide(int delay) {
    const auto known = delays_.find(delay);
    if (known != delays_.end()) return known->second;
    bool collide = false;
    for (int i = std::min(0, delay); i <= std::max(own_[0], own_[1] + delay) && !collide; ++i) {
      collide = sampled_.arms_meet(position(0, i), position(1, i - delay), 0.0);
    }
    return delays_[delay] = collide;
  }

 private:
  double position(int arm, int step) const { return scene_.motions[arm].at(step * step_).position; }

  bool is_hit(int arm, int start) {
    for (int i = 0; i < count_; ++i) {
      const int own = std::clamp(i - start, 0, own_[arm]);
      const auto [known, is_new] = met_[arm].try_emplace({own, i}, false);
      if (is_new) known->second = sampled_.meets(arm, position(arm, own), i * step_, 0.0);
      if (known->second) return true;
    }
    return false;
  }

  const Scene& scene_;
  Sampled sampled_;
  double step_;
  int count_ = 0;
  std::array<int, kArmCount> own_{};
  std::array<std::map<std::pair<int, int>, bool>, kArmCount> met_;
  std::array<std::vector<bool>, kArmCount> hits_;
  std::map<int, bool> delays_;
};

/// The exact answer for a scene.
std::optional<StartTimes> exact(const Scene& scene) {
  const double clearance = scene.problem.options.clearance;
  const IntervalSet delays =
      *forbidden_delays(ForbiddenSet(scene.problem, clearance), scene.motions[0], scene.motions[1], Budget());
  const Interval ever = {0.0, kInfinity};
  return best_start_times({delays.complement({-kInfinity, kInfinity}), starts_of(scene, 0)->complement(ever),
                           starts_of(scene, 1)->complement(ever)},
                          timing_of(scene.motions[0]), timing_of(scene.motions[1]), kInfinity);
}

TEST(ForbiddenStarts, WithTheDelaysGiveTheBestPairOfAScanOfAllPairs) {
  int waits = 0;
  int none = 0;
  int scenes = 0;
  for (int seed = 0; scenes < 200; ++seed) {
    ASSERT_LT(seed, 2000);
    SCOPED_TRACE(seed);
    const Scene scene = random_traffic_scene(seed);
    if (scene.motions.size() != 2) continue;
    ++scenes;
    const Sampled sampled(scene);
    const auto times = exact(scene);
    if (times) {
      EXPECT_EQ(sampled.culprit(times->first, times->second, -2e-6), Culprit::kNone)
          << times->first << " " << times->second;
      waits += times->first + times->second > 0.0 ? 1 : 0;
    } else {
      ++none;
    }
    // No pair of the scan is better, unless a closer look finds that it collides between two steps.
    Scan scan(scene);
    while (const auto best = scan.best()) {
      if (times && best->duration > times->duration - 1e-9) break;
      const double first = best->first * scan.step();
      const double second = best->second * scan.step();
      const Culprit seen = sampled.culprit(first, second, sampled.slack_between_instants(first, second));
      ASSERT_NE(seen, Culprit::kNone) << "better: " << first << " " << second;
      scan.blame(*best, seen);
    }
  }
  EXPECT_GT(waits, 60);
  EXPECT_GT(none, 5);
}

TEST(ForbiddenStarts, HoldEveryStartThatTheScanSeesColliding) {
  int hits = 0;
  int free = 0;
  for (int seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_traffic_scene(seed);
    if (scene.motions.size() != 2) continue;
    const Scan scan(scene);
    for (int arm = 0; arm < kArmCount; ++arm) {
      const IntervalSet starts = starts_of(scene, arm).value();
      for (int i = 0; i < scan.count(); ++i) {
        (scan.hits(arm, i) ? hits : free) += 1;
        EXPECT_TRUE(!scan.hits(arm, i) || starts.contains(i * scan.step())) << "arm " << arm << " step " << i;
      }
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(free, 200);
}

/// One arm of 1 m that turns by `goal` rad, and one object.
Scene one_arm_scene(double goal, const Shape& shape, const std::vector<std::pair<double, Eigen::Vector3d>>& track) {
  Problem problem = paper_problem({0, 90}, {0, 90}, 0.1);
  problem.arms[0].length = 1.0;
  problem.arms[1].base.position.x() = 100.0;
  problem.tasks[0].goal.position = goal;
  std::vector<TimedPose> poses;
  for (const auto& [time, place] : track) {
    poses.push_back({time, Eigen::Isometry3d(Eigen::Translation3d(place))});
  }
  problem.objects = {{"mover", shape, MovingPlacement{PoseTrack(poses)}}};
  return Scene(problem);
}

const Shape kBall = Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.1};

TEST(ForbiddenStarts, OfAnObjectThatCrossesTheGoalAreAllThatWouldBeThereBefore) {
  // Along the line through the tip at the goal, 90 degrees: within 0.2 m of the link from 4.8 s to 5.2 s.
  const Scene scene = one_arm_scene(0.5 * kPi, kBall, {{0.0, {-5.0, 0.5, 0.0}}, {10.0, {5.0, 0.5, 0.0}}});
  const IntervalSet starts = starts_of(scene, 0).value();
  ASSERT_EQ(starts.intervals().size(), 1u);
  EXPECT_EQ(starts.intervals()[0].lower, -kInfinity);
  // It leaves to the right, towards the link that comes from there: it has to be past the start, too.
  EXPECT_GT(starts.intervals()[0].upper, 5.2 - scene.motions[0].duration());
  const Sampled sampled(scene);
  EXPECT_EQ(sampled.culprit(starts.intervals()[0].upper + 1e-6, 0.0, 0.0), Culprit::kNone);
  EXPECT_EQ(sampled.culprit(starts.intervals()[0].upper - 1e-2, 0.0, 0.0), Culprit::kFirst);
}

TEST(ForbiddenStarts, OfAnObjectThatCrossesTheStartAreAllLaterOnes) {
  // Crosses the standing link at right angles, at 0.5 m from the joint: within 0.2 m of its axis from 4.8 s to 5.2 s.
  const Scene scene = one_arm_scene(0.5 * kPi, kBall, {{0.0, {0.5, -5.0, 0.0}}, {10.0, {0.5, 5.0, 0.0}}});
  const IntervalSet starts = starts_of(scene, 0).value();
  ASSERT_EQ(starts.intervals().size(), 1u);
  EXPECT_EQ(starts.intervals()[0].upper, kInfinity);
  EXPECT_LT(starts.intervals()[0].lower, 4.8);
  EXPECT_GT(starts.intervals()[0].lower, 4.8 - scene.motions[0].duration());
}

TEST(ForbiddenStarts, OfAnArmThatDoesNotMoveAreAllOrNone) {
  const Scene hit = one_arm_scene(0.0, kBall, {{0.0, {0.5, -5.0, 0.0}}, {10.0, {0.5, 5.0, 0.0}}});
  EXPECT_TRUE(starts_of(hit, 0)->covers({-kInfinity, kInfinity}));
  const Scene missed = one_arm_scene(0.0, kBall, {{0.0, {1.21, -5.0, 0.0}}, {10.0, {1.21, 5.0, 0.0}}});
  EXPECT_TRUE(starts_of(missed, 0)->empty());
}

TEST(ForbiddenStarts, OfAnObjectThatParksAtTheGoalAreAll) {
  const Scene scene = one_arm_scene(0.5 * kPi, kBall, {{0.0, {-5.0, 0.5, 0.0}}, {9.0, {-0.1, 0.5, 0.0}}});
  EXPECT_TRUE(starts_of(scene, 0)->covers({-kInfinity, kInfinity}));
}

TEST(ForbiddenStarts, DoNotCountWhatPassedBeforeThePlan) {
  const Scene scene = one_arm_scene(0.5 * kPi, kBall, {{-10.0, {0.5, -5.0, 0.0}}, {-0.1, {0.5, 5.0, 0.0}}});
  EXPECT_TRUE(starts_of(scene, 0)->empty());
}

TEST(ForbiddenStarts, AskNothingOfAnArmThatMovesOnFromItsGoal) {
  Scene scene = one_arm_scene(0.5 * kPi, kBall, {{0.0, {-5.0, 0.5, 0.0}}, {10.0, {5.0, 0.5, 0.0}}});
  auto motion = fastest_motion(scene.systems[0], {0.0, 0.0}, {0.5 * kPi, 0.5});
  scene.motions[0] = std::get<FastestMotion>(motion).profile;
  EXPECT_FALSE(starts_of(scene, 0)->contains(0.0));
}

TEST(ForbiddenStarts, AreNotGivenHalf) {
  const Scene scene = one_arm_scene(0.5 * kPi, kBall, {{0.0, {-5.0, 0.5, 0.0}}, {10.0, {5.0, 0.5, 0.0}}});
  const Budget gone(Budget::Clock::now() - std::chrono::seconds(1));
  EXPECT_FALSE(forbidden_starts(scene.motions[0], scene.problem.arms[0].base, moving_bodies(scene.problem, 0),
                                tracked_bodies(scene.problem), 0.0, gone));
}

/// The least distance beyond the clearance of arm and objects with a start time, sought to rounding near the least of
/// many instants.
double least_gap(const Scene& scene, int arm, double start) {
  const auto gap = [&](double time) {
    const Eigen::Isometry3d pose =
        link_pose(scene.problem.arms[arm].base, scene.motions[arm].at(time - start).position);
    double least = kInfinity;
    for (const TrackedBody& object : tracked_bodies(scene.problem)) {
      const Shape there = placed(object.body.shape, object.track->pose_at(time));
      for (const Body& body : moving_bodies(scene.problem, arm)) {
        least = std::min(least, clearance(placed(body.shape, pose), there).distance);
      }
    }
    return least - scene.problem.options.clearance;
  };
  const double end = std::max(start + scene.motions[arm].duration(), scene.end_of_tracks());
  double step = end / 2000.0;
  double best = 0.0;
  for (double time = 0.0; time <= end; time += step) best = gap(time) < gap(best) ? time : best;
  for (; step > 1e-11; step *= 0.5) {
    for (const double time : {best - step, best + step})
      best = gap(std::max(time, 0.0)) < gap(best) ? std::max(time, 0.0) : best;
  }
  return gap(best);
}

TEST(ForbiddenStarts, EndWhereArmAndObjectTouch) {
  int ends = 0;
  for (int seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_traffic_scene(seed);
    if (scene.motions.size() != 2) continue;
    for (int arm = 0; arm < kArmCount; ++arm) {
      const IntervalSet starts = starts_of(scene, arm).value();
      for (const Interval& piece : starts.intervals()) {
        for (const double end : {piece.lower, piece.upper}) {
          if (!std::isfinite(end) || end < 0.0) continue;
          ++ends;
          EXPECT_NEAR(least_gap(scene, arm, end), 0.0, 1e-6) << "arm " << arm << " end " << end;
        }
      }
    }
  }
  EXPECT_GT(ends, 50);
}

}  // namespace
}  // namespace dualarm

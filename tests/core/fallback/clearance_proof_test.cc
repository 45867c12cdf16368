#include "core/fallback/clearance_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/fallback/random.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr double kClearance = 0.02;
const Budget kUnlimited;

struct Verdict {
  bool proven;
  double smallest_gap;
};

/// A random pair of motions, judged by the proof and by 2,000 samples.
Verdict judge(const Problem& problem, const Systems& systems, const ClearanceProof& proof, Random& random) {
  std::array<std::vector<ProfileTable>, kArmCount> tables;
  std::array<Track, kArmCount> tracks;
  Schedule schedule;
  double end = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    double time = random.in({0.0, 0.5});
    double at = random.in({0.0, 2.0});
    for (int leg = 0; leg < 2; ++leg) {
      const double to = random.in({0.0, 2.0});
      const Profile profile = steer(*systems[arm], at, to).value();
      schedule[arm].push_back({time, profile});
      tables[arm].emplace_back(profile);
      time += profile.duration() + random.in({0.0, 0.5});
      at = to;
    }
    end = std::max(end, time);
    for (int leg = 0; leg < 2; ++leg) tracks[arm].push_back({schedule[arm][leg].start_time, &tables[arm][leg]});
  }
  return {proof.proves(tracks, {0.0, end}), smallest_gap(problem, schedule, end, 2000)};
}

TEST(ClearanceProof, NeverHoldsForMotionsThatComeTooClose) {
  SCOPED_TRACE(kSeed);
  Problem problem = retreat_problem();
  problem.objects.push_back(standing_ball(-3.0, 3.0));
  const ArmSystems arms(problem);
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  Random random(kSeed);
  int proven = 0;
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    const auto [holds, gap] = judge(problem, arms.both(), proof, random);
    if (holds) {
      EXPECT_GE(gap, kClearance) << "pair " << i;
    } else {
      EXPECT_LT(gap, kClearance + 0.01) << "pair " << i << " is free and was not proven";
    }
    ++(holds ? proven : refused);
  }
  EXPECT_GE(proven, 30);
  EXPECT_GE(refused, 30);
}

TEST(ClearanceProof, MeasuresWhatIsLeftBeyondTheClearance) {
  const Problem problem = retreat_problem();
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  // Both upright, parallel, 8 m apart, radii 0.05 m each.
  EXPECT_NEAR(proof.slack({90.0 * kDegree, 90.0 * kDegree}), 8.0 - 0.1 - kClearance, 1e-4);
  EXPECT_LT(proof.slack({30.0 * kDegree, 30.0 * kDegree}), 0.0);
}

TEST(ClearanceProof, CountsFixedAndCarriedBodies) {
  Problem problem = retreat_problem();
  const JointPair upright = {90.0 * kDegree, 90.0 * kDegree};
  problem.objects.push_back(standing_ball(1.0, 5.0));
  EXPECT_NEAR(ClearanceProof(problem, 0.0, kUnlimited).slack(upright), 1.0 - 0.05 - 0.2, 1e-4);

  AttachedPlacement hook;
  hook.arm = 1;
  hook.pose_in_link.translation() = Eigen::Vector3d(6.0, 0.0, 0.0);
  const Capsule towards_left = {{0.0, 0.0, 0.0}, {0.0, 7.5, 0.0}, 0.1};
  problem.objects = {{"bar", towards_left, hook}};
  EXPECT_NEAR(ClearanceProof(problem, 0.0, kUnlimited).slack(upright), 0.5 - 0.05 - 0.1, 1e-4);
}

TEST(ClearanceProof, HoldsForArmsThatRestApart) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const ProfileTable first(*steer(*arms.both()[0], 1.5, 1.5));
  const ProfileTable second(*steer(*arms.both()[1], 1.5, 1.5));
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  EXPECT_TRUE(proof.proves({Track{{0.0, &first}}, Track{{0.0, &second}}}, {0.0, 1.0}));
}

TEST(ClearanceProof, SeesAMotionThatSwingsIntoTheOtherArmAndBack) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  const double away = 100.0 * kDegree;
  const double into = 20.0 * kDegree;
  std::vector<Arc> arcs = steer(*arms.both()[0], away, into).value().arcs();
  const Profile back = steer(*arms.both()[0], into, away).value();
  arcs.insert(arcs.end(), back.arcs().begin(), back.arcs().end());
  const ProfileTable swing(Profile(*arms.both()[0], arcs));
  const ProfileTable in_the_way(*steer(*arms.both()[1], 30.0 * kDegree, 30.0 * kDegree));
  const ProfileTable out_of_the_way(*steer(*arms.both()[1], 150.0 * kDegree, 150.0 * kDegree));
  EXPECT_FALSE(proof.proves({Track{{0.0, &swing}}, Track{{0.0, &in_the_way}}}, {0.0, swing.duration()}));
  EXPECT_TRUE(proof.proves({Track{{0.0, &swing}}, Track{{0.0, &out_of_the_way}}}, {0.0, swing.duration()}));
}

/// A ball of 0.3 m that passes through the arms' room from one point to another within a time.
Object passing_ball(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Interval time) {
  MovingPlacement way;
  way.track = PoseTrack({{time.lower, Eigen::Isometry3d(Eigen::Translation3d(from))},
                         {time.upper, Eigen::Isometry3d(Eigen::Translation3d(to))}});
  return {"ball", Capsule{{0, 0, 0}, {0, 0, 0}, 0.3}, way};
}

/// Two arms, one with a box in its hand; a can stands, a bar tumbles through between 0 and 3 s.
Problem crowded_problem() {
  Problem problem = retreat_problem();
  AttachedPlacement hand;
  hand.arm = 0;
  hand.pose_in_link = Eigen::Translation3d(6.0, 0.0, 0.0) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  Box load;
  load.half_extents = {0.4, 0.2, 0.3};
  FixedPlacement there;
  there.pose.translation() = Eigen::Vector3d(-2.0, 5.0, 0.0);
  MovingPlacement tumble;
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  tumble.track = PoseTrack({{0.0, Eigen::Translation3d(9.0, 7.0, 1.0) * Eigen::AngleAxisd(0.0, axis)},
                            {1.5, Eigen::Translation3d(5.0, 4.0, 0.0) * Eigen::AngleAxisd(2.0, axis)},
                            {3.0, Eigen::Translation3d(1.0, 8.0, 0.0) * Eigen::AngleAxisd(4.0, axis)}});
  problem.objects = {{"load", load, hand},
                     {"can", Cylinder{{0, 0, -0.3}, {0, 0, 0.5}, 0.4}, there},
                     {"bar", Cylinder{{-0.8, 0, 0}, {0.8, 0, 0}, 0.1}, tumble}};
  return problem;
}

/// Smallest distance of what may collide, at one instant.
double gap_at(const Problem& problem, const JointPair& positions, double time) {
  std::array<std::vector<Shape>, kArmCount> arms;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Eigen::Isometry3d pose = link_pose(problem.arms[arm].base, positions[arm]);
    for (const Body& body : moving_bodies(problem, arm)) arms[arm].push_back(placed(body.shape, pose));
  }
  std::vector<Shape> others;
  for (const Body& body : fixed_bodies(problem)) others.push_back(body.shape);
  for (const TrackedBody& tracked : tracked_bodies(problem)) {
    others.push_back(placed(tracked.body.shape, tracked.track->pose_at(time)));
  }
  double smallest = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::vector<Shape>& some, const std::vector<Shape>& more) {
    for (const Shape& first : some) {
      for (const Shape& second : more) smallest = std::min(smallest, clearance(first, second).distance);
    }
  };
  consider(arms[0], arms[1]);
  consider(arms[0], others);
  consider(arms[1], others);
  return smallest;
}

TEST(ClearanceProof, NeverHoldsForMotionsThatComeTooCloseToAnyShapeCarriedOrStandingOrMoving) {
  SCOPED_TRACE(kSeed);
  const Problem problem = crowded_problem();
  const ArmSystems arms(problem);
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  Random random(kSeed);
  int proven = 0;
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    std::array<std::optional<ProfileTable>, kArmCount> tables;
    std::array<double, kArmCount> starts{};
    for (int arm = 0; arm < kArmCount; ++arm) {
      starts[arm] = random.in({0.0, 1.5});
      tables[arm].emplace(*steer(*arms.both()[arm], random.in({0.5, 2.5}), random.in({0.5, 2.5})));
    }
    const std::array<Track, kArmCount> tracks = {Track{{starts[0], &*tables[0]}}, Track{{starts[1], &*tables[1]}}};
    constexpr Interval kTime = {0.2, 3.5};
    double smallest = std::numeric_limits<double>::infinity();
    for (int look = 0; look <= 150; ++look) {
      const double time = kTime.lower + kTime.length() * look / 150;
      const JointPair positions = {tables[0]->position(time - starts[0]), tables[1]->position(time - starts[1])};
      smallest = std::min(smallest, gap_at(problem, positions, time));
    }
    if (proof.proves(tracks, kTime)) {
      ++proven;
      EXPECT_GE(smallest, kClearance);
    } else {
      ++refused;
      EXPECT_LT(smallest, kClearance + 0.1) << "free and not proven";
    }
  }
  EXPECT_GE(proven, 30);
  EXPECT_GE(refused, 30);
}

TEST(ClearanceProof, MeetsAMovingObjectOnlyAtItsTime) {
  Problem problem = retreat_problem();
  problem.objects = {passing_ball({-9.0, 5.0, 0.0}, {9.0, 5.0, 0.0}, {4.0, 5.0})};
  const ArmSystems arms(problem);
  const double upright = 90.0 * kDegree;
  const ProfileTable first(*steer(*arms.both()[0], upright, upright));
  const ProfileTable second(*steer(*arms.both()[1], upright, upright));
  const std::array<Track, kArmCount> resting = {Track{{0.0, &first}}, Track{{0.0, &second}}};
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  EXPECT_TRUE(proof.proves(resting, {0.0, 4.4}));
  EXPECT_FALSE(proof.proves(resting, {0.0, 4.6})) << "it is at the first arm at 4.5 s";
  EXPECT_FALSE(proof.proves(resting, {4.45, 4.6}));
  EXPECT_FALSE(proof.proves(resting, {0.0, 100.0})) << "it passes within one long rest";
  EXPECT_TRUE(proof.proves(resting, {5.0, 100.0}));
  EXPECT_EQ(proof.settled_time(), 5.0);
  EXPECT_NEAR(proof.slack({upright, upright}), 8.0 - 0.1 - kClearance, 1e-4) << "rests are judged without it";
}

TEST(ClearanceProof, KnowsWhenAnObjectHasLeftAPlaceForGood) {
  Problem problem = retreat_problem();
  problem.objects = {passing_ball({-9.0, 5.0, 0.0}, {9.0, 5.0, 0.0}, {4.0, 5.0})};
  const double upright = 90.0 * kDegree;
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  // 18 m/s past an arm of 0.05 m with 0.3 m: it is at the arm at 4.5 s.
  EXPECT_NEAR(proof.free_from(0, upright), 4.5 + (0.3 + 0.05 + kClearance) / 18.0, 1e-3);
  EXPECT_EQ(proof.free_from(0, 0.0), -std::numeric_limits<double>::infinity());
  problem.objects = {passing_ball({-9.0, 5.0, 0.0}, {0.0, 5.0, 0.0}, {4.0, 5.0})};
  EXPECT_EQ(ClearanceProof(problem, kClearance, kUnlimited).free_from(0, upright),
            std::numeric_limits<double>::infinity());
}

TEST(ClearanceProof, ProvesNothingOnceTheBudgetIsUsedUp) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const ProfileTable standing(*steer(*arms.both()[0], 1.5, 1.5));
  const Budget none({}, [] { return true; });
  EXPECT_FALSE(
      ClearanceProof(problem, kClearance, none).proves({Track{{0.0, &standing}}, Track{{0.0, &standing}}}, {0.0, 1.0}));
}

TEST(ClearanceProof, SettlesAtOnceWhereNothingMovesByItself) {
  EXPECT_EQ(ClearanceProof(retreat_problem(), kClearance, kUnlimited).settled_time(),
            -std::numeric_limits<double>::infinity());
}

TEST(ClearanceProof, HasNothingToProveWhereNoTwoBodiesCanEverMeet) {
  Problem problem = retreat_problem();
  problem.arms[1].base.position.z() = 1.0;
  problem.objects = {standing_ball(9.0, 9.0), passing_ball({-9.0, 9.0, 0.0}, {9.0, 9.0, 0.0}, {0.0, 1.0})};
  problem.arms[0].base.position.x() = -2.0;
  const ClearanceProof proof(problem, kClearance, kUnlimited);
  EXPECT_EQ(proof.slack({0.3, 0.3}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace dualarm

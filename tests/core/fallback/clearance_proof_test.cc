#include "core/fallback/clearance_proof.h"

#include <gtest/gtest.h>

#include "core/fallback/random.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr double kClearance = 0.02;

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
  return {proof.proves(tracks), smallest_gap(problem, schedule, end, 2000)};
}

TEST(ClearanceProof, NeverHoldsForMotionsThatComeTooClose) {
  SCOPED_TRACE(kSeed);
  Problem problem = retreat_problem();
  problem.objects.push_back(standing_ball(-3.0, 3.0));
  const ArmSystems arms(problem);
  const ClearanceProof proof(problem, kClearance);
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
  const ClearanceProof proof(problem, kClearance);
  // Both upright, parallel, 8 m apart, radii 0.05 m each.
  EXPECT_NEAR(proof.slack({90.0 * kDegree, 90.0 * kDegree}), 8.0 - 0.1 - kClearance, 1e-4);
  EXPECT_LT(proof.slack({30.0 * kDegree, 30.0 * kDegree}), 0.0);
}

TEST(ClearanceProof, CountsFixedAndCarriedBodies) {
  Problem problem = retreat_problem();
  const JointPair upright = {90.0 * kDegree, 90.0 * kDegree};
  problem.objects.push_back(standing_ball(0.0, 7.0));
  EXPECT_NEAR(ClearanceProof(problem, 0.0).slack(upright), 1.0 - 0.05 - 0.2, 1e-4);

  AttachedPlacement hook;
  hook.arm = 1;
  hook.pose_in_link.translation() = Eigen::Vector3d(6.0, 0.0, 0.0);
  const Capsule towards_left = {{0.0, 0.0, 0.0}, {0.0, 7.5, 0.0}, 0.1};
  problem.objects = {{"bar", towards_left, hook}};
  EXPECT_NEAR(ClearanceProof(problem, 0.0).slack(upright), 0.5 - 0.05 - 0.1, 1e-4);
}

TEST(ClearanceProof, HoldsForArmsThatRestApart) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const ProfileTable first(*steer(*arms.both()[0], 1.5, 1.5));
  const ProfileTable second(*steer(*arms.both()[1], 1.5, 1.5));
  const ClearanceProof proof(problem, kClearance);
  EXPECT_TRUE(proof.proves({Track{{0.0, &first}}, Track{{0.0, &second}}}));
}

TEST(ClearanceProof, SeesAMotionThatSwingsIntoTheOtherArmAndBack) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const ClearanceProof proof(problem, kClearance);
  const double away = 100.0 * kDegree;
  const double into = 20.0 * kDegree;
  std::vector<Arc> arcs = steer(*arms.both()[0], away, into).value().arcs();
  const Profile back = steer(*arms.both()[0], into, away).value();
  arcs.insert(arcs.end(), back.arcs().begin(), back.arcs().end());
  const ProfileTable swing(Profile(*arms.both()[0], arcs));
  const ProfileTable in_the_way(*steer(*arms.both()[1], 30.0 * kDegree, 30.0 * kDegree));
  const ProfileTable out_of_the_way(*steer(*arms.both()[1], 150.0 * kDegree, 150.0 * kDegree));
  EXPECT_FALSE(proof.proves({Track{{0.0, &swing}}, Track{{0.0, &in_the_way}}}));
  EXPECT_TRUE(proof.proves({Track{{0.0, &swing}}, Track{{0.0, &out_of_the_way}}}));
}

}  // namespace
}  // namespace dualarm

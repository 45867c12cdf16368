#include "core/fallback/profile_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fallback/random.h"
#include "core/fallback/steering.h"
#include "tests/core/fallback/scenes.h"

namespace dualarm {
namespace {

constexpr std::uint64_t kSeed = 11;

/// Not a multiple of the table's pieces: most of these lie between its knots.
constexpr int kInstantsPerArc = 77;

TEST(ProfileTable, FollowsTheExactMotionFarCloserThanAProofAllowsFor) {
  SCOPED_TRACE(kSeed);
  const ArmSystems arms(retreat_problem());
  Random random(kSeed);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    const auto profile = steer(*arms.both()[0], random.in({0.0, 3.1}), random.in({0.0, 3.1}));
    ASSERT_TRUE(profile);
    const ProfileTable table(*profile);
    EXPECT_EQ(table.duration(), profile->duration());
    for (const Arc& arc : profile->arcs()) {
      const std::vector<JointState> states = profile->states_along(arc, kInstantsPerArc);
      for (int k = 0; k <= kInstantsPerArc; ++k) {
        const double time = arc.start_time + (arc.end_time - arc.start_time) * k / kInstantsPerArc;
        worst = std::max(worst, std::abs(table.position(time) - states[k].position));
      }
    }
  }
  EXPECT_LT(worst, 1e-8);
  RecordProperty("worst_error_rad", std::to_string(worst));
}

/// Largest departure (rad) of a profile's table from the exact motion.
double worst_error(const Profile& profile) {
  const ProfileTable table(profile);
  double worst = 0.0;
  for (const Arc& arc : profile.arcs()) {
    const std::vector<JointState> states = profile.states_along(arc, kInstantsPerArc);
    for (int k = 0; k <= kInstantsPerArc; ++k) {
      const double time = arc.start_time + (arc.end_time - arc.start_time) * k / kInstantsPerArc;
      worst = std::max(worst, std::abs(table.position(time) - states[k].position));
    }
  }
  return worst;
}

TEST(ProfileTable, FollowsArcsWhoseAccelerationBendsAsClosely) {
  SCOPED_TRACE(kSeed);
  Problem problem = retreat_problem();
  problem.arms[0].torque =
      TorqueTable{{0.4, 0.9, 1.5},
                  {-0.7, 0.0, 0.6},
                  {{-60, 45}, {-70, 60}, {-40, 50}, {-45, 70}, {-80, 90}, {-50, 40}, {-70, 60}, {-60, 45}, {-90, 60}}};
  problem.arms[1].torque = TorqueSpeedLine{60.0, 2.0};
  problem.arms[1].viscous_friction = 6.0;
  const ArmSystems arms(problem);
  Random random(kSeed);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    const auto profile = steer(*arms.both()[i % 2], random.in({0.0, 3.1}), random.in({0.0, 3.1}));
    ASSERT_TRUE(profile);
    worst = std::max(worst, worst_error(*profile));
  }
  EXPECT_LT(worst, 1e-7);
  RecordProperty("worst_error_rad", std::to_string(worst));
}

TEST(ProfileTable, FollowsAnArcThatNearlyStallsAsClosely) {
  // theory, section 1.3: the monotone motion of a drive of 1.01 times gravity's most lingers where gravity is largest.
  Problem problem = retreat_problem();
  problem.arms[0].torque =
      Interval{-1.01 * problem.arms[0].gravity.amplitude, 1.01 * problem.arms[0].gravity.amplitude};
  problem.arms[0].velocity = {-20.0, 20.0};
  const ArmSystems arms(problem);
  EXPECT_LT(worst_error(steer(*arms.both()[0], 90.0 * kDegree, 180.0 * kDegree).value()), 1e-7);
}

TEST(ProfileTable, KnowsWhereTheMotionTurnsBack) {
  const ArmSystems arms(retreat_problem());
  const Profile there = steer(*arms.both()[0], 0.2, 1.1).value();
  std::vector<Arc> arcs = there.arcs();
  const Profile back = steer(*arms.both()[0], 1.1, 0.7).value();
  arcs.insert(arcs.end(), back.arcs().begin(), back.arcs().end());
  EXPECT_TRUE(ProfileTable(there).turning_times().empty());
  const ProfileTable table(Profile(*arms.both()[0], arcs));
  ASSERT_EQ(table.turning_times().size(), 1u);
  EXPECT_DOUBLE_EQ(table.turning_times().front(), there.duration());
  EXPECT_NEAR(table.position(there.duration()), 1.1, 1e-12);
}

TEST(ProfileTable, RestsBeforeAndAfter) {
  const ArmSystems arms(retreat_problem());
  const ProfileTable table(*steer(*arms.both()[0], 0.2, 1.1));
  EXPECT_EQ(table.position(-3.0), 0.2);
  EXPECT_EQ(table.position(0.0), 0.2);
  EXPECT_EQ(table.position(table.duration()), 1.1);
  EXPECT_EQ(table.position(99.0), 1.1);
}

TEST(ProfileTable, OfStandingStillHasOnePosition) {
  const ArmSystems arms(retreat_problem());
  const ProfileTable table(*steer(*arms.both()[0], 0.2, 0.2));
  EXPECT_EQ(table.duration(), 0.0);
  EXPECT_EQ(table.position(-1.0), 0.2);
  EXPECT_EQ(table.position(1.0), 0.2);
}

}  // namespace
}  // namespace dualarm

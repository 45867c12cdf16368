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

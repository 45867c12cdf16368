#include "core/passage/gate_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/phase_plane/metered_system.h"
#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

const double kTip = std::acos(2.0 / 3.0);  // theory.md, section 2

struct WorkedRow {
  std::array<double, 2> start;
  std::array<double, 2> goal;
  double bound;
  double digits;
};

class WorkedBounds : public testing::TestWithParam<WorkedRow> {};

TEST_P(WorkedBounds, AreReachedToThePrintedDigits) {
  const WorkedRow& row = GetParam();
  const SceneTravellers scene(paper_problem(row.start, row.goal));
  for (const int pinned : {0, 1}) {
    const Gate tip = {pinned, kTip, kTip, true};
    const GateBound bound = gate_bound(scene.travellers, tip);
    EXPECT_NEAR(bound.duration, row.bound, row.digits);
    EXPECT_GE(gate_estimate(scene.travellers, tip).duration, bound.duration);
    // The two extremal motions meet in the gate, and neither takes longer.
    EXPECT_NEAR(bound.early.before + bound.late.after, bound.duration, 1e-8);
    EXPECT_LE(bound.early.duration(), bound.duration + 1e-8);
    EXPECT_LE(bound.late.duration(), bound.duration + 1e-8);
  }
}

// theory.md, section 4.
INSTANTIATE_TEST_SUITE_P(
    Theory, WorkedBounds,
    testing::Values(WorkedRow{{30, 60}, {60, 30}, 1.500925, 1e-6}, WorkedRow{{20, 90}, {90, 20}, 1.793744, 1e-6},
                    WorkedRow{{20, 70}, {60, 20}, 1.79374, 1e-5}, WorkedRow{{10, 80}, {60, 15}, 1.96053, 1e-5},
                    WorkedRow{{5, 60}, {50, 10}, 2.08796, 1e-5}, WorkedRow{{10, 40}, {40, 10}, 2.14425, 1e-5}));

TEST(GateBound, IsTheSameWithTimeReversed) {
  const SceneTravellers there(paper_problem({5, 60}, {50, 10}));
  const SceneTravellers back(paper_problem({50, 10}, {5, 60}));
  const Gate tip = {0, kTip, kTip, true};
  const GateBound bound = gate_bound(there.travellers, tip);
  const GateBound reverse = gate_bound(back.travellers, tip);
  EXPECT_EQ(bound.early_arm, 0);
  EXPECT_EQ(reverse.early_arm, 1);
  EXPECT_NEAR(bound.duration, reverse.duration, 1e-9);
}

TEST(GateBound, IsTheSameFromThatOfAGateNearBy) {
  for (const auto& [start, goal] : {std::pair{5.0, 50.0}, {10.0, 40.0}, {20.0, 60.0}}) {
    const SceneTravellers scene(paper_problem({start, 60}, {goal, 10}));
    const Gate gate = {0, kTip - 0.01, kTip + 1e-3, true};
    const GateBound near_by = gate_bound(scene.travellers, {0, kTip, kTip, true});
    const GateBound cold = gate_bound(scene.travellers, gate);
    EXPECT_NEAR(gate_bound(scene.travellers, gate, &near_by).duration, cold.duration, 1e-10);
    // A floor above the bound hides it, one below does not.
    EXPECT_LE(gate_bound(scene.travellers, gate, &near_by, 1.1 * cold.duration).duration, 1.1 * cold.duration);
    EXPECT_NEAR(gate_bound(scene.travellers, gate, &near_by, 0.999 * cold.duration).duration, cold.duration, 1e-10);
  }
}

TEST(GateBound, KnowsHowItGrowsAlongABorder) {
  const SceneTravellers scene(paper_problem({5, 60}, {50, 10}));
  for (const double corner_slope : {-1.0, 0.0, 2.0}) {
    const auto at = [&](double way) {
      return gate_bound(scene.travellers, {0, kTip + way, kTip - 0.01 + corner_slope * way, true});
    };
    const GateBound here = at(0.0);
    const Gate gate = {0, kTip, kTip - 0.01, true};
    const double slope = here.price * crossing_slope(gate, corner_slope, here.early_arm, here.early, here.late);
    EXPECT_NEAR(slope, (at(1e-4).duration - at(-1e-4).duration) / 2e-4, 1e-4);
    EXPECT_GT(here.price, 0.1);
  }
}

TEST(GateBound, AsksForTheDetourOnlyOfAGateOnWhichTheOtherArmStands) {
  // Arm 2 is beyond the corner all the time; arm 1 has to come to the gate and back.
  const SceneTravellers scene(paper_problem({20, 100}, {30, 110}));
  const Gate gate = {0, in_radians(60.0), in_radians(80.0), true};
  const Through through(scene.travellers[0], in_radians(60.0), Hurry::kEarlyArrival);
  EXPECT_EQ(gate_bound(scene.travellers, gate).duration, through.least().duration());
}

TEST(GateBound, IsInfiniteWhereAnArmCannotBe) {
  const SceneTravellers scene(paper_problem({30, 60}, {60, 30}));
  EXPECT_TRUE(std::isinf(gate_bound(scene.travellers, {0, 3.2, 1.0, true}).duration));
}

TEST(GateBound, IsSmallerWithLessWorkWhenTheBudgetRunsOut) {
  for (const auto& [start, goal] : {std::pair{5.0, 50.0}, {10.0, 40.0}, {20.0, 60.0}}) {
    const SceneTravellers scene(paper_problem({start, 60}, {goal, 10}));
    const std::array<MeteredSystem, 2> metered = {MeteredSystem(scene.systems[0]), MeteredSystem(scene.systems[1])};
    Travellers travellers = scene.travellers;
    for (int arm = 0; arm < kArmCount; ++arm) travellers[arm].system = &metered[arm];
    const Gate tip = {0, kTip, kTip, true};
    const double bound = gate_bound(travellers, tip).duration;
    const long whole = metered[0].count() + metered[1].count();
    const double less = gate_bound(travellers, tip, nullptr, 0.0, Budget({}, [] { return true; })).duration;
    EXPECT_LT(less, bound);
    EXPECT_GE(less, std::max(travellers[0].fastest.duration(), travellers[1].fastest.duration()));
    EXPECT_LT(metered[0].count() + metered[1].count() - whole, whole);
  }
}

TEST(GateBound, RunsBothWays) {
  // The mirror image of the paper's first row below the corner: all angles negated, and gravity with them.
  Problem problem = paper_problem({-30, -60}, {-60, -30});
  for (Arm& arm : problem.arms) arm.joint_range = {-std::numbers::pi, 0.0};
  const SceneTravellers scene(problem);
  EXPECT_NEAR(gate_bound(scene.travellers, {0, -kTip, -kTip, false}).duration, 1.500925, 1e-6);
}

}  // namespace
}  // namespace dualarm

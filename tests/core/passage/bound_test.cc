#include "core/passage/bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

PassageBound bound_of(const Problem& problem, double clearance = 0.0) {
  const SceneTravellers scene(problem);
  return passage_bound(ForbiddenPlane(problem, clearance), scene.travellers, Budget());
}

TEST(PassageBound, FindsTheSlowestGateOfThePapersLensAtItsTip) {
  const double tip = std::acos(2.0 / 3.0);
  const PassageBound bound = bound_of(paper_problem({5, 60}, {50, 10}));
  EXPECT_NEAR(bound.duration, 2.08796, 1e-5);
  ASSERT_EQ(bound.ways.size(), 1u);
  EXPECT_NEAR(bound.ways.front().gate.pinned_position, tip, 1e-4);
  EXPECT_NEAR(bound.ways.front().gate.corner_position, tip, 1e-4);
  EXPECT_TRUE(bound.ways.front().gate.runs_up);
}

TEST(PassageBound, GrowsWithTheClearance) {
  double previous = 0.0;
  for (const double clearance : {0.0, 0.01, 0.1, 0.3}) {
    const double duration = bound_of(paper_problem({5, 60}, {50, 10}, 0.05), clearance).duration;
    EXPECT_GT(duration, previous);
    previous = duration;
  }
}

TEST(PassageBound, IsTheSameForTheArmsExchangedAndForTimeReversed) {
  const double bound = bound_of(paper_problem({10, 80}, {60, 15}, 0.1)).duration;
  EXPECT_NEAR(bound_of(paper_problem({80, 10}, {15, 60}, 0.1)).duration, bound, 1e-8);
  EXPECT_NEAR(bound_of(paper_problem({60, 15}, {10, 80}, 0.1)).duration, bound, 1e-8);
}

TEST(PassageBound, LooksAtNoObstacleThatTheFastestMotionsDoNotMeet) {
  EXPECT_TRUE(bound_of(paper_problem({100, 90}, {140, 150}, 0.1)).ways.empty());
}

TEST(PassageBound, CountsTheFasterWayAroundAnObstacleThatIsOpenOnBothSides) {
  const double around_tip = bound_of(paper_problem({30, 60}, {60, 30}, 0.1)).duration;
  for (const double elbows : {1.0, -1.0}) {  // up or down; the paper's gravity is the same for both
    for (const double low : {30, 60}) {
      Problem problem = paper_problem({elbows * low, elbows * (90 - low)}, {elbows * (90 - low), elbows * low}, 0.1);
      for (Arm& arm : problem.arms) arm.joint_range = {-std::numbers::pi, std::numbers::pi};
      const PassageBound open = bound_of(problem);
      ASSERT_EQ(open.ways.size(), 2u);
      EXPECT_NEAR(open.duration, around_tip, 1e-9);
      EXPECT_GT(open.ways[1].bound.duration, open.ways[0].bound.duration + 0.1);
      EXPECT_EQ(open.ways[0].gate.runs_up, elbows > 0.0);
      EXPECT_EQ(open.ways[1].gate.runs_up, elbows < 0.0);
    }
  }
}

TEST(PassageBound, IsInfiniteWhereTheForbiddenSetPartsStartFromGoal) {
  // Arms that cannot lift beyond the lens never get around its tip.
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.1);
  for (Arm& arm : problem.arms) arm.joint_range = {0.0, in_radians(45.0)};
  EXPECT_TRUE(std::isinf(bound_of(problem).duration));
  for (Arm& arm : problem.arms) arm.joint_range = {0.0, in_radians(60.0)};
  EXPECT_TRUE(std::isfinite(bound_of(problem).duration));
}

TEST(PassageBound, EndsWithItsBudgetAndSaysSo) {
  const Problem problem = paper_problem({10, 40}, {40, 10});
  const SceneTravellers scene(problem);
  const Budget gone(Budget::Clock::now() - std::chrono::seconds(1));
  const PassageBound bound = passage_bound(ForbiddenPlane(problem, 0.0), scene.travellers, gone);
  EXPECT_FALSE(bound.is_whole);
  EXPECT_LE(bound.duration, 2.14425);
}

}  // namespace
}  // namespace dualarm

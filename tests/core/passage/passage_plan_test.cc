#include "core/passage/passage_plan.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMargin = 1e-4;  // m

struct Planned {
  PassageBound bound;
  double duration = kInfinity;
  double extremal = kInfinity;  ///< s, of the two extremal motions, free or not
  StartTimes times;
};

Planned planned(const Problem& problem, double max_delay = kInfinity, double known = kInfinity) {
  const SceneTravellers scene(problem);
  Planned planned;
  planned.bound = passage_bound(ForbiddenPlane(problem, kMargin), scene.travellers, Budget());
  const Way& way = planned.bound.ways.at(0);
  if (const auto extremal = extremal_plan(scene.travellers, way, 0.0, max_delay)) {
    planned.extremal = extremal->times.duration;
  }
  const auto plan =
      passage_plan(ForbiddenSet(problem, kMargin), scene.travellers, way, 0.0, known, max_delay, Budget());
  if (!plan) return planned;
  planned.duration = plan->times.duration;
  planned.times = plan->times;
  return planned;
}

TEST(PassagePlan, ReachesTheBoundWithTheTwoExtremalMotions) {
  for (const double radius : {0.0, 1e-3, 0.1}) {
    const Planned plan = planned(paper_problem({5, 60}, {50, 10}, radius));
    EXPECT_NEAR(plan.extremal, plan.bound.duration, 1e-8);
    EXPECT_NEAR(plan.duration, plan.bound.duration, 1e-8);
    EXPECT_EQ(std::min(plan.times.first, plan.times.second), 0.0);
  }
}

TEST(PassagePlan, SeeksDetoursWhereTheExtremalMotionsClipTheSet) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.2);
  for (Arm& arm : problem.arms) arm.inertia = 12.0;
  const Planned plan = planned(problem);
  EXPECT_GT(plan.duration, plan.extremal * (1.0 + 1e-3));
  EXPECT_NEAR(plan.bound.duration, 1.2405, 1e-4);  // theory.md, section 4
  EXPECT_LT(plan.duration, 1.270);                 // a transcription finds 1.2654
}

TEST(PassagePlan, KeepsTheLargestWait) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 0.1);
  EXPECT_GT(planned(problem).times.second, 0.1);
  const Planned plan = planned(problem, 0.05);
  EXPECT_LE(std::max(plan.times.first, plan.times.second), 0.05);
  EXPECT_NEAR(plan.duration, plan.bound.duration, 1e-3);  // arm 2 swings back instead of waiting
}

TEST(PassagePlan, IsSilentWhereAKnownPlanIsAsFast) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 1e-3);
  const double bound = planned(problem).bound.duration;
  EXPECT_EQ(planned(problem, kInfinity, bound * (1.0 - 1e-6)).duration, kInfinity);
}

}  // namespace
}  // namespace dualarm

#include "core/fallback/refine.h"

#include <gtest/gtest.h>

#include "tests/core/fallback/legs.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"

namespace dualarm {
namespace {

/// One arm after the other over the lens's tip, with a needless rest and needless waits.
Itinerary clumsy_retreat(const Systems& systems) {
  Itinerary itinerary(systems, at_rest({10.0 * kDegree, 40.0 * kDegree}));
  const auto leg = [&](int arm, double time, double from, double to) {
    append_leg(itinerary, systems, arm, time, from * kDegree, to * kDegree);
  };
  leg(1, 0.5, 40.0, 50.0);
  leg(1, 2.0, 50.0, 60.0);
  leg(0, 4.0, 10.0, 30.0);
  leg(0, 6.0, 30.0, 60.0);
  leg(1, 9.0, 60.0, 10.0);
  leg(0, 12.0, 60.0, 40.0);
  return itinerary;
}

TEST(Refinement, ShortensAClumsyPlanToNearlyTheBestAndKeepsItFree) {
  const Problem problem = retreat_problem();
  const ArmSystems arms(problem);
  const Budget unlimited;
  const ClearanceProof proof(problem, 1e-4, unlimited);
  const Itinerary clumsy = clumsy_retreat(arms.both());
  ASSERT_TRUE(proof.proves(clumsy.tracks(), {0.0, clumsy.duration()}));
  Random random(1);
  Refinement refinement(arms.both(), proof, clumsy, {}, random, unlimited);
  refinement.run(6000);
  EXPECT_LT(refinement.best().duration(), 1.05 * kRetreatBound);
  EXPECT_TRUE(proof.proves(refinement.best().tracks(), {0.0, refinement.best().duration()}));
  EXPECT_NEAR(refinement.evaluations(), 6000, 20);
  expect_consistent(problem, refinement.best().schedule(), refinement.best().duration());
}

TEST(Refinement, StopsAtTheLowerBound) {
  const Problem problem = paper_problem({60.0, 100.0}, {90.0, 120.0});
  const ArmSystems arms(problem);
  const Budget unlimited;
  const ClearanceProof proof(problem, 1e-4, unlimited);
  Itinerary slow(arms.both(), at_rest({60.0 * kDegree, 100.0 * kDegree}));
  append_leg(slow, arms.both(), 0, 1.0, 60.0 * kDegree, 90.0 * kDegree);
  append_leg(slow, arms.both(), 1, 0.0, 100.0 * kDegree, 120.0 * kDegree);
  const double bound =
      minimum_time(arms.both(), at_rest({60.0 * kDegree, 100.0 * kDegree}), at_rest({90.0 * kDegree, 120.0 * kDegree}));
  Random random(1);
  Refinement refinement(arms.both(), proof, slow, {bound}, random, unlimited);
  refinement.run(100000);
  EXPECT_NEAR(refinement.best().duration(), bound, 1e-4);
  EXPECT_LT(refinement.evaluations(), 100);
}

}  // namespace
}  // namespace dualarm

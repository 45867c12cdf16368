#include "core/fallback/fresh_plans.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"
#include "tests/core/fallback/searching.h"

namespace dualarm {
namespace {

constexpr double kAnyDuration = std::numeric_limits<double>::infinity();

/// Plans drawn for a problem.
std::vector<Itinerary> drawn(const Problem& problem, const ArmSystems& arms, std::uint64_t seed, int evaluations,
                             std::size_t count, double longest = kAnyDuration, const Budget& budget = {}) {
  const ClearanceProof proof(problem, kClearance, budget);
  Random random(seed);
  const Itinerary start(arms.both(), {problem.tasks[0].start, problem.tasks[1].start});
  FreshPlans fresh(arms.both(), proof, start, {problem.tasks[0].goal, problem.tasks[1].goal},
                   {0.0, problem.options.max_start_delay}, random, budget);
  double shortest = kAnyDuration;
  fresh.run(evaluations, longest, [&shortest](const Itinerary& better) {
    EXPECT_LT(better.duration(), shortest);
    shortest = better.duration();
  });
  const std::vector<Itinerary> best = fresh.best(1);
  EXPECT_EQ(shortest, best.empty() ? kAnyDuration : best.front().duration()) << "is told of the best at last";
  EXPECT_LE(fresh.evaluations(), evaluations + 10);
  return fresh.best(count);
}

Problem crossing_problem() { return paper_problem({30.0, 60.0}, {60.0, 30.0}); }

TEST(FreshPlans, AreProvenAndDiffer) {
  const Problem problem = crossing_problem();
  const ArmSystems arms(problem);
  for (int seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Itinerary> plans = drawn(problem, arms, seed, 600, 3);
    ASSERT_FALSE(plans.empty());
    EXPECT_LT(plans.front().duration(), 1.6) << "the straight ones";
    for (std::size_t i = 0; i < plans.size(); ++i) {
      expect_consistent(problem, plans[i].schedule(), plans[i].duration());
      EXPECT_GE(smallest_gap(problem, plans[i].schedule(), plans[i].duration(), kInstants), kClearance);
      if (i > 0) {
        EXPECT_GT(plans[i].duration(), 1.01 * plans[i - 1].duration());
      }
    }
  }
}

TEST(FreshPlans, AreTheSameForTheSameSeed) {
  const Problem problem = crossing_problem();
  const ArmSystems arms(problem);
  const std::vector<Itinerary> once = drawn(problem, arms, 7, 400, 1);
  const std::vector<Itinerary> again = drawn(problem, arms, 7, 400, 1);
  ASSERT_FALSE(once.empty() || again.empty());
  EXPECT_EQ(once.front().duration(), again.front().duration());
}

TEST(FreshPlans, GoStraightWhereNothingIsInTheWay) {
  const Problem problem = paper_problem({60.0, 100.0}, {90.0, 170.0});
  const ArmSystems arms(problem);
  const double least = minimum_time(arms.both(), {problem.tasks[0].start, problem.tasks[1].start},
                                    {problem.tasks[0].goal, problem.tasks[1].goal});
  const std::vector<Itinerary> plans = drawn(problem, arms, 1, 100, 1);
  ASSERT_FALSE(plans.empty());
  EXPECT_NEAR(plans.front().duration(), least, 1e-9);
}

TEST(FreshPlans, AreOfNoUseUnlessTheyAreFasterThanWhatIsKnown) {
  const Problem problem = crossing_problem();
  const ArmSystems arms(problem);
  EXPECT_TRUE(drawn(problem, arms, 1, 400, 3, 1.45).empty()) << "none takes less than 1.5009 s";
}

TEST(FreshPlans, LetNoArmFirstMoveLaterThanItMay) {
  Problem problem = paper_problem({30.0, 60.0}, {60.0, 30.0});
  problem.options.max_start_delay = 0.0;
  const ArmSystems arms(problem);
  const std::vector<Itinerary> plans = drawn(problem, arms, 1, 400, 3);
  ASSERT_FALSE(plans.empty());
  for (const Itinerary& plan : plans) EXPECT_EQ(std::max(plan.first_start(0), plan.first_start(1)), 0.0);
}

TEST(FreshPlans, EndWithTheBudget) {
  const Problem problem = crossing_problem();
  EXPECT_TRUE(drawn(problem, ArmSystems(problem), 1, 400, 3, kAnyDuration, Budget({}, [] { return true; })).empty());
}

}  // namespace
}  // namespace dualarm

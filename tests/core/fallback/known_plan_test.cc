#include "core/fallback/known_plan.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/fallback/legs.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/schedule_check.h"
#include "tests/core/fallback/searching.h"

namespace dualarm {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// (30, 60) -> (60, 30) with arm 2 late by `delay` s.
Schedule delayed(const ArmSystems& arms, double delay) {
  return {std::vector{TimedProfile{0.0, *steer(*arms.both()[0], 30.0 * kDegree, 60.0 * kDegree)}},
          {TimedProfile{delay, *steer(*arms.both()[1], 60.0 * kDegree, 30.0 * kDegree)}}};
}

class KnownPlanTest : public ::testing::Test {
 protected:
  KnownPlanTest() : problem_(paper_problem({30.0, 60.0}, {60.0, 30.0})), arms_(problem_) {}

  Itinerary itinerary(const Schedule& schedule) const {
    return itinerary_of(arms_.both(), {problem_.tasks[0].start, problem_.tasks[1].start},
                        {problem_.tasks[0].goal, problem_.tasks[1].goal}, {}, schedule);
  }

  Problem problem_;
  ArmSystems arms_;
};

TEST_F(KnownPlanTest, CutsAMotionIntoAsFewFastestOnesAsMakeIt) {
  const System& system = *arms_.both()[0];
  const JointState passed = {1.3, 0.4};
  const Profile before = *dualarm::steer(system, JointState{0.3, 0.0}, passed);
  const Profile after = *dualarm::steer(system, passed, JointState{0.9, 0.0});
  std::vector<Arc> arcs = before.arcs();
  arcs.insert(arcs.end(), after.arcs().begin(), after.arcs().end());
  const Profile whole(system, arcs);
  const std::vector<Profile> parts = fastest_parts(system, whole);
  EXPECT_GE(parts.size(), 2u);
  EXPECT_LT(parts.size(), arcs.size());
  double time = 0.0;
  for (const Profile& part : parts) {
    EXPECT_NEAR(steering_time(system, part.start_state(), part.goal_state()), part.duration(), 1e-9);
    EXPECT_NEAR(part.at(0.5 * part.duration()).position, whole.at(time + 0.5 * part.duration()).position, 1e-9);
    time += part.duration();
  }
  EXPECT_NEAR(time, whole.duration(), 1e-12);
  EXPECT_EQ(fastest_parts(system, before).size(), 1u);
}

TEST_F(KnownPlanTest, BecomesAnItineraryOfTheSameTimes) {
  const Schedule schedule = delayed(arms_, 0.4);
  const Itinerary same = itinerary(schedule);
  EXPECT_EQ(same.leg_count(0), 1);
  EXPECT_EQ(same.first_start(1), 0.4);
  expect_consistent(problem_, same.schedule(), 0.4 + schedule[1].front().profile.duration());
}

TEST_F(KnownPlanTest, IsMadeALittleLongerWhereItTouches) {
  double touches = 0.0;  // the least delay that is free, to rounding
  for (double step = 0.25; step > 1e-9; step *= 0.5) {
    const double tried = touches + step;
    if (smallest_gap(problem_, delayed(arms_, tried), 3.0, kInstants) < kClearance) touches = tried;
  }
  const Budget budget;
  const ClearanceProof proof(problem_, kClearance, budget);
  const Itinerary exact = itinerary(delayed(arms_, touches));
  ASSERT_FALSE(proof.proves(exact.tracks(), {0.0, exact.duration()}));
  const auto longer = proven_free(proof, exact, kNoLimit);
  ASSERT_TRUE(longer);
  EXPECT_TRUE(proof.proves(longer->tracks(), {0.0, longer->duration()}));
  EXPECT_LE(longer->duration(), 1.011 * exact.duration());
  EXPECT_EQ(proven_free(proof, itinerary(delayed(arms_, touches + 0.1)), kNoLimit)->duration(),
            itinerary(delayed(arms_, touches + 0.1)).duration());
}

TEST_F(KnownPlanTest, IsNotProvenWhereItCollides) {
  const Budget budget;
  const ClearanceProof proof(problem_, kClearance, budget);
  EXPECT_FALSE(proven_free(proof, itinerary(delayed(arms_, 0.0)), kNoLimit));
}

TEST_F(KnownPlanTest, KeepsToTheLargestStartDelay) {
  const Budget budget;
  const ClearanceProof proof(problem_, kClearance, budget);
  const auto early = proven_free(proof, itinerary(delayed(arms_, 0.6)), 0.1);
  ASSERT_TRUE(early);
  EXPECT_LE(early->first_start(1), 0.1);
  EXPECT_NEAR(early->duration(), itinerary(delayed(arms_, 0.6)).duration(), 1e-9);
}

TEST_F(KnownPlanTest, IsWhereASearchBeginsThatTellsFasterOnesOnly) {
  const Schedule slow = delayed(arms_, 1.5);
  SearchRules rules;
  rules.clearance = kClearance;
  rules.evaluation_limit = 500;
  rules.known = KnownSchedule{slow, 1.5 + slow[1].front().profile.duration()};
  rules.on_incumbent = [&](const Schedule&, double duration) { EXPECT_LT(duration, rules.known->duration); };
  const SearchResult faster = search_state_time(problem_, arms_.both(), rules, Budget());
  ASSERT_TRUE(faster.schedule);
  EXPECT_LT(faster.duration, 1.55);  // 1.5010 s is the least
  EXPECT_LE(faster.evaluation_count, 700);
  expect_consistent(problem_, *faster.schedule, faster.duration);
  EXPECT_GE(smallest_gap(problem_, *faster.schedule, faster.duration, kInstants), kClearance);

  rules.known->duration = 1.4;  // faster than there is
  EXPECT_FALSE(search_state_time(problem_, arms_.both(), rules, Budget()).schedule);
}

/// A delay of nothing at all is allowed, and the delay of 0.6 s saves 0.4 s: by a small step at once.
TEST(SearchWithoutDelays, StepsAsideAtOnceAndWaitsThere) {
  Problem problem = paper_problem({20.0, 70.0}, {60.0, 20.0});
  problem.options.max_start_delay = 0.0;
  const ArmSystems arms(problem);
  for (int seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    problem.options.seed = seed;
    const SearchResult result = search(problem, arms, 4000);
    ASSERT_TRUE(result.schedule);
    expect_consistent(problem, *result.schedule, result.duration);
    for (const auto& motions : *result.schedule) EXPECT_EQ(motions.front().start_time, 0.0);
    EXPECT_LE(result.duration, 1.84);
    EXPECT_GE(smallest_gap(problem, *result.schedule, result.duration, kInstants), kClearance);
  }
}

}  // namespace
}  // namespace dualarm

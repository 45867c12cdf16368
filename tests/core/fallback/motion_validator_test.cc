#include "core/fallback/motion_validator.h"

#include <gtest/gtest.h>

#include "tests/core/fallback/search_space.h"

namespace dualarm {
namespace {

JointStates degrees(double first, double second) { return at_rest({first * kDegree, second * kDegree}); }

TEST(StateValidity, WantsClearanceAndStatesThatCanBeHeld) {
  Problem problem = retreat_problem();
  const SearchSpace strong(problem);
  EXPECT_TRUE(strong.information->isValid(strong.state(90.0, 90.0, 0.0).get()));
  EXPECT_FALSE(strong.information->isValid(strong.state(30.0, 30.0, 0.0).get()));
  problem.arms[1].torque = Interval{-25.0, 25.0};  // gravity needs 29.43 at 90 degrees
  const SearchSpace weak(problem);
  EXPECT_FALSE(weak.information->isValid(weak.state(90.0, 90.0, 0.0).get()));
  EXPECT_TRUE(weak.information->isValid(weak.state(90.0, 170.0, 0.0).get()));
}

TEST(EdgeValidator, TakesAMotionInEnoughTimeAndRefusesItInLessOrBackwards) {
  const SearchSpace search(retreat_problem());
  const auto here = search.state(90.0, 90.0, 1.0);
  EXPECT_TRUE(search.information->checkMotion(here.get(), search.state(100.0, 120.0, 4.0).get()));
  EXPECT_FALSE(search.information->checkMotion(here.get(), search.state(100.0, 120.0, 1.1).get()));
  EXPECT_FALSE(search.information->checkMotion(search.state(100.0, 120.0, 4.0).get(), here.get()));
}

TEST(EdgeValidator, RefusesAMotionThroughTheOtherArm) {
  const SearchSpace search(retreat_problem());
  EXPECT_FALSE(
      search.information->checkMotion(search.state(10.0, 60.0, 0.0).get(), search.state(100.0, 5.0, 50.0).get()));
}

TEST(EdgeValidator, ReportsTheFirstStateAsTheLastValidOne) {
  const SearchSpace search(retreat_problem());
  const auto here = search.state(10.0, 40.0, 0.0);
  auto copy = search.state(0.0, 0.0, 0.0);
  std::pair<ompl::base::State*, double> last_valid(copy.get(), 1.0);
  EXPECT_FALSE(search.information->checkMotion(here.get(), search.state(40.0, 10.0, 9.0).get(), last_valid));
  EXPECT_EQ(last_valid.second, 0.0);
  EXPECT_EQ(StateTimeSpace::states(copy.get()), degrees(10.0, 40.0));
}

TEST(Connect, LetsTheFasterArmWaitWhereBothAtOnceWouldCollide) {
  // Arm 1 swings out of arm 2's way while arm 2 comes down a little behind it.
  const SearchSpace search(retreat_problem());
  int waited = 0;
  for (double second_goal = 5.0; second_goal < 45.0; second_goal += 1.0) {
    const auto edge =
        connect(search.arms.both(), search.proof, degrees(20.0, 70.0), degrees(80.0, second_goal), {0.0, 0.0});
    if (!edge) continue;
    EXPECT_NEAR(edge->duration, steering_time(search.arms.both(), degrees(20.0, 70.0), degrees(80.0, second_goal)),
                1e-12);
    const auto& [first, second] = edge->moves;
    EXPECT_EQ(first.wait, 0.0);  // the slower arm never waits
    if (second.wait > 0.0) {
      ++waited;
      EXPECT_NEAR(second.wait + second.lasts, edge->duration, 1e-12);
    }
  }
  EXPECT_GT(waited, 0);
}

}  // namespace
}  // namespace dualarm

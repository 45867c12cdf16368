#include "core/passage/through.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/passage/scene_travellers.h"
#include "tests/support/dice.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kTip = 0.8410686705679303;  // rad, acos(2/3): theory.md, section 2

TEST(Through, IsTheFastestMotionWhereNothingIsHurried) {
  const SceneTravellers scene(paper_problem({5, 60}, {50, 10}));
  const Traveller& arm = scene.travellers[0];
  const Through through(arm, kTip, Hurry::kEarlyArrival);
  ASSERT_TRUE(through.exists());
  EXPECT_EQ(through.least().duration(), arm.fastest.duration());
  EXPECT_EQ(through.within(arm.fastest.duration()).velocity, through.least().velocity);
  EXPECT_EQ(through.motion(through.least())->duration(), arm.fastest.duration());
}

TEST(Through, HurriesMoreTheMoreTimeTheWholeMotionMayTake) {
  const SceneTravellers scene(paper_problem({5, 60}, {50, 10}));
  for (const Hurry hurry : {Hurry::kEarlyArrival, Hurry::kLateDeparture}) {
    for (const Traveller& arm : scene.travellers) {
      const Through through(arm, kTip, hurry);
      double hurried = through.hurried(through.least());
      for (double duration = through.least().duration() + 0.1; duration < through.most().duration(); duration += 0.1) {
        const Passing passing = through.within(duration);
        EXPECT_NEAR(passing.duration(), duration, 1e-9);
        EXPECT_LT(through.hurried(passing), hurried);
        hurried = through.hurried(passing);
      }
      EXPECT_GE(hurried, through.hurried(through.most()));
      EXPECT_EQ(through.within(10.0).velocity, through.most().velocity);
    }
  }
}

TEST(Through, TurnsBackInAPositionBeyondStartAndGoal) {
  const SceneTravellers scene(paper_problem({10, 40}, {40, 10}));
  const Through through(scene.travellers[0], kTip, Hurry::kEarlyArrival);
  EXPECT_EQ(through.least().velocity, 0.0);
  EXPECT_GT(through.most().velocity, 0.0);
  const auto motion = through.motion(through.within(2.1));
  ASSERT_TRUE(motion);
  EXPECT_GT(motion->extent().upper, kTip);
  EXPECT_NEAR(motion->duration(), 2.1, 1e-9);
}

TEST(Through, HasNothingToHurryWhereTheArmStarts) {
  const SceneTravellers scene(paper_problem({30, 60}, {60, 30}));
  const Traveller& arm = scene.travellers[0];
  const Through through(arm, arm.start.position, Hurry::kEarlyArrival);
  EXPECT_EQ(through.least().before, 0.0);
  EXPECT_EQ(through.most().before, 0.0);
  EXPECT_EQ(through.least().after, arm.fastest.duration());
}

TEST(Through, DoesNotExistBeyondTheJointRange) {
  const SceneTravellers scene(paper_problem({30, 60}, {60, 30}));
  EXPECT_FALSE(Through(scene.travellers[0], 3.2, Hurry::kEarlyArrival).exists());
}

/// Positions and speeds of one arm, driven by full torques that change at random, in small steps of time.
struct Driver {
  const System& system;
  JointState state;

  void advance(bool upwards, double step) {
    const Interval velocities = system.velocity();
    const auto rate = [&](JointState at) {
      const Interval admissible = system.acceleration(at.position, at.velocity);
      return upwards ? admissible.upper : admissible.lower;
    };
    const double first = rate(state);
    const JointState middle = {state.position + 0.5 * step * state.velocity, state.velocity + 0.5 * step * first};
    const double second = rate(middle);
    state = {state.position + step * middle.velocity,
             std::clamp(state.velocity + step * second, velocities.lower, velocities.upper)};
  }
};

// Nothing of this knows fastest motions: it is what an arm does under full torques that change at random.
TEST(Through, IsNotBeatenByRandomMotions) {
  constexpr double kStep = 1e-3;
  int compared = 0;
  for (int seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const SceneTravellers scene(paper_problem({dice.between(5.0, 60.0), 100}, {dice.between(20.0, 80.0), 100}));
    const Traveller& arm = scene.travellers[0];
    const double position = in_radians(dice.between(10.0, 85.0));
    const Through through(arm, position, Hurry::kEarlyArrival);
    Driver driver{scene.systems[0], arm.start};
    bool upwards = position > arm.start.position;
    double next = dice.between(0.0, 1.5);
    for (double time = 0.0; time < 3.0; time += kStep) {
      if (time > next) {
        upwards = !upwards;
        next = time + dice.between(0.0, 0.8);
      }
      const double before = driver.state.position - position;
      driver.advance(upwards, kStep);
      if (before * (driver.state.position - position) > 0.0) continue;
      // Here with a speed after so long: no sooner than the family's first half with that speed.
      const double share =
          (driver.state.velocity - through.least().velocity) / (through.most().velocity - through.least().velocity);
      EXPECT_GE(time + 2.0 * kStep, through.most().before);
      if (share > 0.0 && share < 1.0) {
        ++compared;
        EXPECT_GE(time + 5.0 * kStep, through.at(std::sqrt(share)).before) << share;
      }
      break;
    }
  }
  EXPECT_GT(compared, 30);
}

}  // namespace
}  // namespace dualarm

#include "core/fallback/alignment.h"

#include <gtest/gtest.h>

#include "tests/core/fallback/legs.h"
#include "tests/core/fallback/scenes.h"
#include "tests/core/fallback/searching.h"

namespace dualarm {
namespace {

/// (30, 60) -> (60, 30), both straight, with arms of 0.05 m: arm 1 has to go first, and some 1.51 s are enough.
class AlignmentTest : public ::testing::Test {
 protected:
  AlignmentTest()
      : problem_(paper_problem({30.0, 60.0}, {60.0, 30.0})),
        arms_(problem_),
        proof_(problem_, kClearance, budget_),
        straight_(arms_.both(), {problem_.tasks[0].start, problem_.tasks[1].start}) {
    append_leg(straight_, arms_.both(), 0, 0.0, 30.0 * kDegree, 60.0 * kDegree);
    append_leg(straight_, arms_.both(), 1, 0.0, 60.0 * kDegree, 30.0 * kDegree);
  }

  Problem problem_;
  ArmSystems arms_;
  Budget budget_;
  ClearanceProof proof_;
  Itinerary straight_;
};

TEST_F(AlignmentTest, LetsTheSecondArmEndAsEarlyAsIsProvenWhicheverOrderIsTriedFirst) {
  for (const int leader : {0, 1}) {
    Alignment alignment(proof_, {}, budget_);
    const auto found = alignment.shortest(straight_, leader, 3.0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->leader, 0);
    EXPECT_EQ(found->itinerary.first_start(0), 0.0);
    EXPECT_GT(found->itinerary.first_start(1), 0.2);
    EXPECT_LT(found->itinerary.duration(), 1.54);
    EXPECT_TRUE(proof_.proves(found->itinerary.tracks(), {0.0, found->itinerary.duration()}));
    EXPECT_EQ(alignment.evaluations(), 8 + leader);  // the end given, the least, six halvings; the other leader
  }
}

TEST_F(AlignmentTest, FindsNothingThatEndsTooEarly) {
  Alignment alignment(proof_, {}, budget_);
  EXPECT_FALSE(alignment.shortest(straight_, 0, 1.4));
  EXPECT_FALSE(alignment.shortest(straight_, 0, 1.1));
  EXPECT_EQ(alignment.evaluations(), 2);  // of the first: both leaders; the second is less than an arm needs
}

TEST_F(AlignmentTest, TakesAnItineraryAsItIs) {
  Alignment alignment(proof_, {}, budget_);
  Itinerary waiting = straight_;
  waiting.set_wait(1, 0, 1.0);
  const double end = waiting.duration();
  EXPECT_TRUE(alignment.proves_as_is(waiting, end));
  EXPECT_FALSE(alignment.proves_as_is(waiting, 0.9 * end));
  EXPECT_FALSE(alignment.proves_as_is(straight_, straight_.duration()));
}

TEST_F(AlignmentTest, StepsAsideInTimeWhereNoWaitIsAllowed) {
  Alignment alignment(proof_, {0.0, 0.05}, budget_);
  const auto found = alignment.shortest(straight_, 0, 3.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->itinerary.first_start(1), 0.05);
  EXPECT_EQ(found->itinerary.leg_count(1), 2);
  EXPECT_LT(found->itinerary.duration(), 1.54);
}

}  // namespace
}  // namespace dualarm

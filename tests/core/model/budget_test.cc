#include "core/model/budget.h"

#include <gtest/gtest.h>

namespace dualarm {
namespace {

using Seconds = std::chrono::seconds;

TEST(Budget, PartEndsBeforeTheWhole) {
  const Budget whole(Budget::Clock::now() + Seconds(3600));
  EXPECT_FALSE(whole.part(0.5).exhausted());
  EXPECT_TRUE(whole.part(0.0).exhausted());
  EXPECT_FALSE(whole.exhausted());
}

TEST(Budget, PartOfOneThatIsOverIsOver) {
  EXPECT_TRUE(Budget(Budget::Clock::now() - Seconds(1)).part(0.5).exhausted());
}

TEST(Budget, PartOfNoLimitHasNone) { EXPECT_FALSE(Budget().part(0.0).exhausted()); }

TEST(Budget, PartIsCancelledWithTheWhole) {
  bool cancelled = false;
  const Budget part = Budget(Budget::Clock::now() + Seconds(3600), [&] { return cancelled; }).part(0.5);
  EXPECT_FALSE(part.exhausted());
  cancelled = true;
  EXPECT_TRUE(part.cancelled());
  EXPECT_TRUE(part.exhausted());
}

TEST(Budget, LeavesRoomForALastStep) {
  using std::chrono::milliseconds;
  const Budget whole(Budget::Clock::now() + Seconds(3600));
  EXPECT_FALSE(whole.leaving(1.0, Seconds(3599)).exhausted()) << "Never more room than what is given.";
  EXPECT_TRUE(whole.leaving(1.0, Seconds(3601)).exhausted());
  EXPECT_FALSE(whole.leaving(0.9, Seconds(3601)).exhausted()) << "Never more than its share.";
  EXPECT_FALSE(Budget().leaving(1.0, milliseconds(250)).exhausted());
  EXPECT_TRUE(Budget(Budget::Clock::now() - Seconds(1)).leaving(0.2, milliseconds(250)).exhausted());
}

TEST(Budget, KeepsToTheClockItIsGivenInAllItsParts) {
  Budget::Clock::time_point now = {};
  const Budget whole(Budget::Clock::time_point(Seconds(10)), {}, [&] { return now; });
  const Budget part = whole.part(0.5);
  const Budget room = whole.leaving(0.2, Seconds(10));
  EXPECT_FALSE(part.exhausted());
  now += Seconds(6);
  EXPECT_TRUE(part.exhausted());
  EXPECT_FALSE(room.exhausted());
  EXPECT_FALSE(room.part(0.9).exhausted());
  now += Seconds(3);
  EXPECT_TRUE(room.exhausted());
  EXPECT_FALSE(whole.exhausted());
  now += Seconds(1);
  EXPECT_TRUE(whole.exhausted());
}

TEST(Budget, RoomForALastStepIsCancelledWithTheWhole) {
  bool cancelled = false;
  const Budget room = Budget(Budget::Clock::now() + Seconds(3600), [&] { return cancelled; }).leaving(0.2, Seconds(1));
  EXPECT_FALSE(room.exhausted());
  cancelled = true;
  EXPECT_TRUE(room.exhausted());
}

}  // namespace
}  // namespace dualarm

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

}  // namespace
}  // namespace dualarm

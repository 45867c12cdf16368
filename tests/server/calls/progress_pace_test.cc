#include "server/calls/progress_pace.h"

#include <gtest/gtest.h>

namespace dualarm {
namespace {

using std::chrono::milliseconds;

const ProgressPace::Clock::time_point kBegin{std::chrono::hours(1)};

TEST(ProgressPace, LetsNewsWaitForATenthOfASecond) {
  ProgressPace pace(kBegin);
  EXPECT_FALSE(pace.is_due(kBegin + milliseconds(99), true));
  EXPECT_TRUE(pace.is_due(kBegin + milliseconds(100), true));
  pace.told(kBegin + milliseconds(130));
  EXPECT_FALSE(pace.is_due(kBegin + milliseconds(229), true));
  EXPECT_TRUE(pace.is_due(kBegin + milliseconds(230), true));
}

TEST(ProgressPace, SpeaksWithoutNewsWellWithinASecond) {
  ProgressPace pace(kBegin);
  EXPECT_FALSE(pace.is_due(kBegin + milliseconds(499), false));
  EXPECT_TRUE(pace.is_due(kBegin + milliseconds(500), false));
}

}  // namespace
}  // namespace dualarm

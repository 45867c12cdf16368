#include "clients/cpp/progress_report.h"

#include <gtest/gtest.h>

namespace dualarm {
namespace {

using planning::v1::PlanMotionStreamResponse;

TEST(ProgressReport, SaysWhatIsKnownAndNothingElse) {
  PlanMotionStreamResponse event;
  event.mutable_progress()->set_elapsed_s(0.52);
  event.mutable_progress()->set_phase("waiting for a worker");
  EXPECT_EQ(progress_line(event), "     0.5 s  waiting for a worker\n");
  event.mutable_progress()->set_phase("state-time search");
  event.mutable_progress()->set_best_duration_s(2.5);
  event.mutable_progress()->set_lower_bound_s(2.0);
  event.mutable_progress()->set_fallback_evaluation_count(1200);
  EXPECT_EQ(progress_line(event),
            "     0.5 s  state-time search, best plan 2.500000 s, lower bound 2.000000 s, 1200 evaluations\n");
}

TEST(ProgressReport, TellsOfABetterPlanAndLeavesTheOutcomeToItsReport) {
  PlanMotionStreamResponse event;
  event.mutable_incumbent()->set_duration_s(2.5);
  event.mutable_incumbent()->set_method(planning::v1::METHOD_STATE_TIME);
  event.mutable_incumbent()->mutable_certificate()->set_gap(0.25);
  EXPECT_EQ(progress_line(event),
            "            a plan of 2.500000 s by state-time, at most 25.000 % above the best possible\n");
  event.mutable_outcome();
  EXPECT_EQ(progress_line(event), "");
}

}  // namespace
}  // namespace dualarm

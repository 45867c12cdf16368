#include "clients/cpp/portrait_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/clients/sample_answers.h"

namespace dualarm {
namespace {

using namespace planning::v1;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(PortraitReport, TellsDurationClaimArcsAndSwitches) {
  const std::string report = portrait_report("two_arms", "left", sample_portrait());
  EXPECT_THAT(report, StartsWith("two_arms, left: the fastest motion with nothing in its way\n"));
  EXPECT_THAT(report, HasSubstr("duration     2.000000 s\n"));
  EXPECT_THAT(report, HasSubstr("lower bound  2.000000 s\n"));
  EXPECT_THAT(report, HasSubstr("claim        Proven optimal: no motion of any kind is faster.\n"));
  EXPECT_THAT(report, HasSubstr("accelerate     0.000000 s   1.000000 s      28.65 deg     0.000000 rad/s      "
                                "42.97 deg     0.500000 rad/s\n"));
  EXPECT_THAT(report, HasSubstr("brake          1.000000 s"));
  EXPECT_THAT(report, HasSubstr("switch at      1.000000 s                   42.97 deg     0.500000 rad/s   "
                                "accelerate to brake\n"));
  EXPECT_THAT(report, Not(HasSubstr("turn at")));
}

TEST(PortraitReport, CallsASwitchAtRestATurn) {
  GetPhasePortraitResponse response = sample_portrait();
  response.mutable_arcs(1)->mutable_start()->set_velocity_rad_per_s(0.0);
  EXPECT_THAT(portrait_report("x", "left", response), HasSubstr("turn at        1.000000 s"));
}

TEST(PortraitReport, HasASentenceForEachClaim) {
  GetPhasePortraitResponse response = sample_portrait();
  response.set_claim(CLAIM_OPTIMAL_MONOTONE);
  EXPECT_THAT(claim_sentence(response), HasSubstr("never turns back"));
  response.set_claim(CLAIM_GAP);
  EXPECT_THAT(claim_sentence(response), HasSubstr("a faster one may exist"));
}

TEST(PortraitReport, SaysThatAnArmStandsStill) {
  GetPhasePortraitResponse response = sample_portrait();
  response.clear_arcs();
  response.set_duration_s(0.0);
  EXPECT_THAT(portrait_report("x", "left", response), HasSubstr("stands still"));
}

TEST(PortraitReport, SaysWhyThereIsNoMotion) {
  GetPhasePortraitResponse response;
  response.mutable_infeasible()->set_reason(REASON_START_TOO_FAST);
  response.mutable_infeasible()->set_explanation("left starts with 9 rad/s");
  EXPECT_EQ(portrait_report("x", "left", response),
            "x, left: no motion exists\n\n  reason       start too fast\n  because      left starts with 9 rad/s\n");
  response.Clear();
  response.mutable_undecided()->set_explanation("nothing found");
  response.mutable_undecided()->set_lower_bound_s(1.5);
  EXPECT_EQ(portrait_report("x", "left", response),
            "x, left: undecided\n\n  because      nothing found\n  lower bound  1.500000 s\n");
}

}  // namespace
}  // namespace dualarm

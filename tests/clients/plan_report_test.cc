#include "clients/cpp/plan_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "clients/cpp/plan_table.h"
#include "clients/cpp/verification_report.h"
#include "clients/cpp/wording.h"
#include "tests/clients/sample_answers.h"

namespace dualarm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(PlanReport, OfAPlanSaysWhenEachArmMovesAndWhatIsProven) {
  const std::string report = plan_report("two_arms", sample_plan());
  EXPECT_THAT(report, StartsWith("two_arms: a verified plan\n"));
  EXPECT_THAT(report, HasSubstr("duration     3.000000 s, method delay"));
  EXPECT_THAT(report, HasSubstr("lower bound  2.500000 s, gap 20.00 %"));
  EXPECT_THAT(report, HasSubstr("at most 20.00 % above the proven lower bound"));
  EXPECT_THAT(report, HasSubstr("left           1.000000 s   2.000000 s      28.65 deg      57.30 deg"));
  EXPECT_THAT(report,
              HasSubstr("0.125000 m between left/link and <right>/link at 1.500000 s, proven at every instant"));
  EXPECT_THAT(report, HasSubstr("took         4.200 ms"));
  EXPECT_THAT(report, Not(HasSubstr("BROKEN")));
}

TEST(PlanReport, ExplainsWhatTheLowerBoundRestsOn) {
  auto response = sample_plan();
  auto& certificate = *response.mutable_plan()->mutable_certificate();
  EXPECT_THAT(plan_report("two_arms", response),
              HasSubstr("lower bound: the slower arm on its own takes at least 2.500000 s.\n"));
  certificate.set_claim(planning::v1::CLAIM_OPTIMAL);
  certificate.set_source(planning::v1::LOWER_BOUND_SOURCE_PASSAGE);
  certificate.mutable_gate()->set_pinned_arm("<right>");
  certificate.mutable_gate()->set_pinned_position_rad(0.5);
  certificate.mutable_gate()->set_corner_position_rad(1.0);
  EXPECT_THAT(plan_report("two_arms", response),
              HasSubstr("no motion of any kind is faster, because <right> and left have to pass each other where "
                        "<right> is at 28.65 deg and left at 57.30 deg, which takes 2.500000 s.\n"));
}

TEST(PlanReport, NamesSafeDelaysAndBrokenDemands) {
  auto response = sample_plan();
  auto& delay = *response.mutable_plan()->mutable_certificate()->add_safe_start_delays_s();
  delay.set_min(-std::numeric_limits<double>::infinity());
  delay.set_max(-1.0);
  response.mutable_plan()->mutable_verification()->set_collision_free(false);
  response.mutable_plan()->mutable_verification()->add_violations()->set_explanation("too close");
  const std::string report = plan_report("two_arms", response);
  EXPECT_THAT(report, HasSubstr("<right> may start later than left by [-inf, -1.000000] s"));
  EXPECT_THAT(report, AllOf(HasSubstr("NOT proven"), HasSubstr("BROKEN       too close")));
}

TEST(PlanReport, SaysWhenNothingOfAMotionWasJudged) {
  planning::v1::Verification verification;
  verification.add_violations()->set_explanation(" has 0 knots; a motion has at least two");
  EXPECT_EQ(verification_lines(verification),
            "  not judged   clearance and limits: the trajectories are no motion\n"
            "  BROKEN       a trajectory that names no arm has 0 knots; a motion has at least two\n");
}

TEST(PlanReport, WritesHugeSharesOfALimitShortly) {
  planning::v1::Verification verification;
  verification.mutable_torque_utilisation()->set_arm("left");
  verification.mutable_torque_utilisation()->set_value(1.5e200);
  EXPECT_THAT(verification_lines(verification), HasSubstr("torque 1.50e+202 % (left at 0.000000 s)\n"));
  EXPECT_EQ(percent(0.99984), "99.98 %");
}

TEST(PlanReport, OfARefusalGivesReasonAndExplanation) {
  const std::string report = plan_report("two_arms", sample_infeasible());
  EXPECT_THAT(report, StartsWith("two_arms: no plan exists within what the request allows\n"));
  EXPECT_THAT(report, HasSubstr("reason       torque too small"));
  EXPECT_THAT(report, HasSubstr("because      left needs 70 N m"));
}

TEST(PlanTable, PutsEveryNumberUnderItsTitle) {
  const std::string header = table_header();
  const std::string row = table_row("two_arms", sample_plan());
  const auto ends_under = [&](const std::string& title, const std::string& value) {
    return header.find(title) + title.size() == row.find(value) + value.size();
  };
  EXPECT_TRUE(ends_under("duration [s]", "3.000000")) << header << row;
  EXPECT_TRUE(ends_under("lower bound [s]", "2.500000")) << header << row;
  EXPECT_TRUE(ends_under("gap [%]", "20.000")) << header << row;
  EXPECT_TRUE(ends_under("clearance [m]", "0.125000")) << header << row;
  EXPECT_TRUE(ends_under("took [ms]", "4.200")) << header << row;
}

TEST(PlanTable, SaysWhyThereIsNoPlan) {
  EXPECT_THAT(table_row("two_arms", sample_infeasible()), HasSubstr("infeasible    left needs 70 N m"));
  EXPECT_EQ(table_row("two_arms", "first line\nsecond line"), "two_arms         ERROR         first line\n");
}

}  // namespace
}  // namespace dualarm

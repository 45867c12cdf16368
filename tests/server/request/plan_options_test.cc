#include "server/request/plan_options.h"

#include <gtest/gtest.h>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

TEST(ReadPlanOptions, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<PlanCase> cases = {
      {"clearance", [](auto& r) { r.mutable_options()->set_clearance_m(-0.01); }, "options.clearance_m",
       "is -0.01, must be 0 to 10000 m"},
      {"clearance NaN", [](auto& r) { r.mutable_options()->set_clearance_m(kNan); }, "options.clearance_m", "is nan"},
      {"no time", [](auto& r) { r.mutable_options()->mutable_planning_budget(); }, "options.planning_budget",
       "is 0 s and 0 ns, must be above 0"},
      {"negative time", [](auto& r) { r.mutable_options()->mutable_planning_budget()->set_seconds(-1); },
       "options.planning_budget", "is -1 s"},
      {"bad nanos", [](auto& r) { r.mutable_options()->mutable_planning_budget()->set_nanos(1'000'000'000); },
       "options.planning_budget", "must be above 0"},
      {"region", [](auto& r) { r.mutable_options()->set_region_model(static_cast<wire::RegionModel>(9)); },
       "options.region_model", "is 9, must be REGION_MODEL_EXACT"},
      {"method unset", [](auto& r) { r.mutable_options()->add_methods(wire::METHOD_UNSPECIFIED); },
       "options.methods[0]", "is 0, must be METHOD_SIMULTANEOUS"},
      {"twice",
       [](auto& r) {
         r.mutable_options()->add_methods(wire::METHOD_DELAY);
         r.mutable_options()->add_methods(wire::METHOD_DELAY);
       },
       "options.methods[1]", "is METHOD_DELAY, which is listed already"},
      {"many methods",
       [](auto& r) {
         for (int i = 0; i < 17; ++i) r.mutable_options()->add_methods(wire::METHOD_DELAY);
       },
       "options.methods", "has 17 entries"},
      {"period negative", [](auto& r) { r.mutable_options()->set_knot_period_s(-0.01); }, "options.knot_period_s",
       "is -0.01, must be 0.001 to 10 s"},
      {"period short", [](auto& r) { r.mutable_options()->set_knot_period_s(0.999e-3); }, "options.knot_period_s",
       "is 0.000999, must be 0.001 to 10 s"},
      {"period NaN", [](auto& r) { r.mutable_options()->set_knot_period_s(kNan); }, "options.knot_period_s", "is nan"},
      {"delay", [](auto& r) { r.mutable_options()->set_max_start_delay_s(-1.0); }, "options.max_start_delay_s",
       "is -1"},
  };
  for (const PlanCase& expected : cases) expect_violation(paper_request(), expected);
}

TEST(ReadPlanOptions, RefusesThePapersRegionForOtherMountings) {
  wire::PlanMotionRequest request = paper_request();
  request.mutable_options()->set_region_model(wire::REGION_MODEL_PAPER);
  EXPECT_TRUE(violations_of(request).empty());
  request.mutable_robot()->mutable_arms(1)->mutable_base()->set_y_m(0.5);
  const auto found = violations_of(request);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].field, "options.region_model");
  EXPECT_THAT(found[0].description, ::testing::HasSubstr("use REGION_MODEL_EXACT"));
}

TEST(ReadPlanOptions, FillsInTheDefaults) {
  const auto parsed = parse(paper_request());
  const auto& wish = std::get<PlanWish>(parsed);
  EXPECT_EQ(wish.problem.options.clearance, 0.0);
  EXPECT_EQ(wish.problem.options.knot_period, 0.01);
  EXPECT_EQ(wish.problem.options.max_start_delay, kInfinity);
  EXPECT_EQ(wish.problem.options.region_model, RegionModel::kExact);
  EXPECT_TRUE(wish.problem.options.methods.empty());
  EXPECT_FALSE(wish.budget.has_value());
  EXPECT_FALSE(wish.validate_only);
}

TEST(ReadPlanOptions, TakesEveryOptionToItsPlace) {
  wire::PlanMotionRequest request = paper_request();
  wire::PlanOptions& options = *request.mutable_options();
  options.set_clearance_m(0.05);
  options.mutable_planning_budget()->set_seconds(2);
  options.mutable_planning_budget()->set_nanos(500'000'000);
  options.set_seed(77);
  options.set_validate_only(true);
  options.add_methods(wire::METHOD_STATE_TIME);
  options.set_knot_period_s(0.001);
  options.set_max_start_delay_s(0.0);
  const auto parsed = parse(request);
  const auto& wish = std::get<PlanWish>(parsed);
  EXPECT_EQ(wish.problem.options.clearance, 0.05);
  EXPECT_EQ(wish.budget, std::chrono::milliseconds(2500));
  EXPECT_EQ(wish.problem.options.seed, 77u);
  EXPECT_TRUE(wish.validate_only);
  EXPECT_EQ(wish.problem.options.methods, std::vector<Method>{Method::kStateTime});
  EXPECT_EQ(wish.problem.options.knot_period, 0.001);
  EXPECT_EQ(wish.problem.options.max_start_delay, 0.0);
}

}  // namespace
}  // namespace dualarm

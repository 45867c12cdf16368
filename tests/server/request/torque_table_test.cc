#include "server/request/torque_table.h"

#include <gtest/gtest.h>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

wire::TorqueTable& table_of(wire::PlanMotionRequest& request) {
  return *request.mutable_robot()->mutable_arms(0)->mutable_torque_limit()->mutable_table();
}

void resize(wire::TorqueTable& table, int positions, int velocities) {
  table.Clear();
  for (int i = 0; i < positions; ++i) {
    table.add_position_rad(0.1 * i);
    wire::TorqueTableRow& row = *table.add_rows();
    row.mutable_min_newton_meters()->Resize(velocities, -60.0);
    row.mutable_max_newton_meters()->Resize(velocities, 60.0);
  }
  for (int k = 0; k < velocities; ++k) table.add_velocity_rad_per_s(0.1 * k);
}

/// The paper's request; the first arm has a table of 4 positions and 3 velocities.
wire::PlanMotionRequest table_request() {
  wire::PlanMotionRequest request = paper_request();
  resize(table_of(request), 4, 3);
  return request;
}

const std::string kTable = "robot.arms[0].torque_limit.table";

TEST(ReadTorqueTable, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<PlanCase> cases = {
      {"no positions",
       [](auto& r) {
         table_of(r).clear_position_rad();
         table_of(r).clear_rows();
       },
       kTable + ".position_rad", "has 0 entries, must have 1 to 1000"},
      {"no velocities", [](auto& r) { table_of(r).clear_velocity_rad_per_s(); }, kTable + ".velocity_rad_per_s",
       "has 0 entries, must have 1 to 1000"},
      {"many positions", [](auto& r) { resize(table_of(r), 1001, 3); }, kTable + ".position_rad",
       "has 1001 entries, must have 1 to 1000"},
      {"many velocities", [](auto& r) { resize(table_of(r), 2, 1001); }, kTable + ".velocity_rad_per_s",
       "has 1001 entries, must have 1 to 1000"},
      {"many in all", [](auto& r) { resize(table_of(r), 317, 316); }, kTable,
       "has 317 positions times 316 velocities = 100172 entries, must have at most 100000 in all"},
      {"equal positions", [](auto& r) { table_of(r).set_position_rad(2, 0.1); }, kTable + ".position_rad[2]",
       "is 0.1, must exceed position_rad[1] = 0.1"},
      {"falling velocities", [](auto& r) { table_of(r).set_velocity_rad_per_s(1, -7.0); },
       kTable + ".velocity_rad_per_s[1]", "is -7, must exceed velocity_rad_per_s[0] = 0"},
      {"position NaN", [](auto& r) { table_of(r).set_position_rad(1, kNan); }, kTable + ".position_rad[1]", "is nan"},
      {"position far", [](auto& r) { table_of(r).set_position_rad(3, 1e4); }, kTable + ".position_rad[3]",
       "is 10000, must be -1000 to 1000 rad"},
      {"velocity infinite", [](auto& r) { table_of(r).set_velocity_rad_per_s(2, kInfinity); },
       kTable + ".velocity_rad_per_s[2]", "is inf"},
      {"row missing", [](auto& r) { table_of(r).mutable_rows()->RemoveLast(); }, kTable + ".rows",
       "has 3 entries, must have 4 as position_rad has"},
      {"row short", [](auto& r) { table_of(r).mutable_rows(1)->mutable_min_newton_meters()->RemoveLast(); },
       kTable + ".rows[1].min_newton_meters", "has 2 entries, must have 3 as velocity_rad_per_s has"},
      {"row long", [](auto& r) { table_of(r).mutable_rows(3)->add_max_newton_meters(1.0); },
       kTable + ".rows[3].max_newton_meters", "has 4 entries, must have 3 as velocity_rad_per_s has"},
      {"turned", [](auto& r) { table_of(r).mutable_rows(3)->set_max_newton_meters(2, -60.0); },
       kTable + ".rows[3].max_newton_meters[2]", "is -60, must exceed min_newton_meters[2] = -60"},
      {"torque NaN", [](auto& r) { table_of(r).mutable_rows(0)->set_min_newton_meters(1, kNan); },
       kTable + ".rows[0].min_newton_meters[1]", "is nan"},
      {"torque infinite", [](auto& r) { table_of(r).mutable_rows(2)->set_max_newton_meters(0, kInfinity); },
       kTable + ".rows[2].max_newton_meters[0]", "is inf, must be"},
      {"units of torque",
       [](auto& r) {
         for (auto& row : *table_of(r).mutable_rows()) {
           for (double& torque : *row.mutable_max_newton_meters()) torque = 1e12;
         }
       },
       "robot.arms[0].torque_limit", "check the units of torque and inertia"},
  };
  EXPECT_TRUE(violations_of(table_request()).empty());
  for (const PlanCase& expected : cases) expect_violation(table_request(), expected);
}

TEST(ReadTorqueTable, RefusesLimitsThatChangeTooFastWithTheVelocity) {
  wire::PlanMotionRequest request = table_request();
  table_of(request).set_velocity_rad_per_s(1, 1e-9);
  EXPECT_TRUE(violations_of(request).empty()) << "equal limits may stand as close as they like";
  table_of(request).mutable_rows(2)->set_max_newton_meters(1, 70.0);
  const auto found = violations_of(request);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].field, kTable + ".velocity_rad_per_s[1]");
  EXPECT_NE(found[0].description.find("must be at most 1000 1/s"), std::string::npos) << found[0].description;
}

TEST(ReadTorqueTable, AnEmptyTableLacksBothGrids) {
  wire::PlanMotionRequest request = paper_request();
  table_of(request);
  const auto found = violations_of(request);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].field, kTable + ".position_rad");
  EXPECT_EQ(found[1].field, kTable + ".velocity_rad_per_s");
}

TEST(ReadTorqueTable, ListsAllViolationsOfOneTable) {
  wire::PlanMotionRequest request = table_request();
  table_of(request).set_position_rad(1, -1.0);
  table_of(request).mutable_rows(0)->set_max_newton_meters(0, -61.0);
  table_of(request).mutable_rows(2)->mutable_min_newton_meters()->Clear();
  table_of(request).mutable_rows(2)->mutable_max_newton_meters()->Clear();
  EXPECT_EQ(violations_of(request).size(), 4u);
}

TEST(ReadTorqueTable, TakesEveryNumberToItsPlace) {
  wire::PlanMotionRequest request = table_request();
  table_of(request).mutable_rows(2)->set_min_newton_meters(1, -5.0);
  table_of(request).mutable_rows(2)->set_max_newton_meters(1, 7.0);
  const auto parsed = parse(request);
  const auto& table = std::get<TorqueTable>(std::get<PlanWish>(parsed).problem.arms[0].torque);
  EXPECT_EQ(table.positions, (std::vector<double>{0.0, 0.1, 0.2, 0.1 * 3}));
  EXPECT_EQ(table.velocities, (std::vector<double>{0.0, 0.1, 0.2}));
  ASSERT_EQ(table.limits.size(), 12u);
  EXPECT_EQ(table.limits[2 * 3 + 1], (Interval{-5.0, 7.0}));
  EXPECT_EQ(table.limits[2 * 3 + 2], (Interval{-60.0, 60.0}));
  EXPECT_EQ(torque_limits(std::get<PlanWish>(parsed).problem.arms[0].torque, 0.2, 0.1), (Interval{-5.0, 7.0}));
}

TEST(ReadTorqueTable, TakesTheLargestAndTheSmallestTable) {
  wire::PlanMotionRequest request = table_request();
  for (const auto& [positions, velocities] : {std::pair{1, 1}, {1000, 100}, {100, 1000}}) {
    resize(table_of(request), positions, velocities);
    EXPECT_TRUE(violations_of(request).empty()) << positions << " x " << velocities;
  }
}

}  // namespace
}  // namespace dualarm

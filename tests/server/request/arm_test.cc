#include "server/request/arm.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

wire::Arm& first(wire::PlanMotionRequest& request) { return *request.mutable_robot()->mutable_arms(0); }
wire::Arm& second(wire::PlanMotionRequest& request) { return *request.mutable_robot()->mutable_arms(1); }

void set_line(wire::Arm& arm, double stall_torque, double no_load_speed) {
  wire::TorqueSpeedLine& line = *arm.mutable_torque_limit()->mutable_torque_speed();
  line.set_stall_torque_newton_meters(stall_torque);
  line.set_no_load_speed_rad_per_s(no_load_speed);
}

TEST(ReadArm, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<PlanCase> cases = {
      {"no robot", [](auto& r) { r.clear_robot(); }, "robot", "is missing: give two arms"},
      {"one arm",
       [](auto& r) {
         r.mutable_robot()->mutable_arms()->RemoveLast();
         r.mutable_tasks()->RemoveLast();
       },
       "robot.arms", "has 1 entries, must have exactly 2"},
      {"three arms", [](auto& r) { *r.mutable_robot()->add_arms() = r.robot().arms(0); }, "robot.arms",
       "has 3 entries"},
      {"control character",
       [](auto& r) {
         first(r).set_name("a\nb");
         r.mutable_tasks(0)->set_arm("a\nb");
       },
       "robot.arms[0].name", "is 'a?b', must be at most 64 printable"},
      {"x is NaN", [](auto& r) { first(r).mutable_base()->set_x_m(kNan); }, "robot.arms[0].base.x_m",
       "is nan, must be"},
      {"y is infinite", [](auto& r) { second(r).mutable_base()->set_y_m(-kInfinity); }, "robot.arms[1].base.y_m",
       "is -inf, must be -10000 to 10000 m"},
      {"z far", [](auto& r) { first(r).mutable_base()->set_z_m(1e5); }, "robot.arms[0].base.z_m", "is 100000"},
      {"heading", [](auto& r) { first(r).mutable_base()->set_heading_rad(kInfinity); },
       "robot.arms[0].base.heading_rad", "is inf"},
      {"rotation", [](auto& r) { first(r).mutable_base()->set_rotation(static_cast<wire::Rotation>(7)); },
       "robot.arms[0].base.rotation", "is 7, must be ROTATION_"},
      {"no link", [](auto& r) { first(r).clear_link(); }, "robot.arms[0].link", "is missing: give length_m"},
      {"length zero", [](auto& r) { first(r).mutable_link()->set_length_m(0.0); }, "robot.arms[0].link.length_m",
       "is 0, must be 1e-06 to 10000 m"},
      {"length negative", [](auto& r) { second(r).mutable_link()->set_length_m(-3.0); }, "robot.arms[1].link.length_m",
       "is -3"},
      {"radius negative", [](auto& r) { second(r).mutable_link()->set_radius_m(-0.1); }, "robot.arms[1].link.radius_m",
       "is -0.1, must be 0 to 10000 m"},
      {"range turned", [](auto& r) { first(r).mutable_joint_range()->set_min_rad(1.0); },
       "robot.arms[0].joint_range.max_rad", "is 0, must exceed min_rad = 1"},
      {"range NaN", [](auto& r) { first(r).mutable_joint_range()->set_max_rad(kNan); },
       "robot.arms[0].joint_range.max_rad", "is nan"},
      {"no torque limit", [](auto& r) { second(r).clear_torque_limit(); }, "robot.arms[1].torque_limit",
       "is missing: give constant, torque_speed or table"},
      {"no form of limit", [](auto& r) { second(r).mutable_torque_limit()->clear_constant(); },
       "robot.arms[1].torque_limit.constant",
       "is missing: give min_newton_meters and max_newton_meters, or torque_speed, or table"},
      {"torque turned",
       [](auto& r) { second(r).mutable_torque_limit()->mutable_constant()->set_max_newton_meters(-70.0); },
       "robot.arms[1].torque_limit.constant.max_newton_meters", "is -70, must exceed min_newton_meters = -60"},
      {"stall torque", [](auto& r) { set_line(second(r), 0.0, 5.0); },
       "robot.arms[1].torque_limit.torque_speed.stall_torque_newton_meters", "is 0, must be 1e-12 to 1000000000000"},
      {"no-load speed", [](auto& r) { set_line(second(r), 60.0, -5.0); },
       "robot.arms[1].torque_limit.torque_speed.no_load_speed_rad_per_s", "is -5, must be 1e-09 to 1000000 rad/s"},
      {"units of a line", [](auto& r) { set_line(first(r), 1e9, 1e-3); },
       "robot.arms[0].torque_limit.torque_speed.no_load_speed_rad_per_s", "check the units of friction, speed"},
      {"units of a line's torque", [](auto& r) { set_line(first(r), 1e11, 1e6); }, "robot.arms[0].torque_limit",
       "check the units of torque and inertia"},
      {"units of torque",
       [](auto& r) { second(r).mutable_torque_limit()->mutable_constant()->set_max_newton_meters(1e12); },
       "robot.arms[1].torque_limit", "check the units of torque and inertia"},
      {"no velocity limit", [](auto& r) { first(r).clear_velocity_limit(); }, "robot.arms[0].velocity_limit",
       "is missing: give min_rad_per_s"},
      {"velocity zero", [](auto& r) { first(r).mutable_velocity_limit()->set_max_rad_per_s(0.0); },
       "robot.arms[0].velocity_limit.max_rad_per_s", "is 0, must be 0.0001 to inf rad/s"},
      {"velocity sign", [](auto& r) { first(r).mutable_velocity_limit()->set_min_rad_per_s(1.0); },
       "robot.arms[0].velocity_limit.min_rad_per_s", "is 1, must be -inf to -0.0001 rad/s"},
  };
  for (const PlanCase& expected : cases) expect_violation(paper_request(), expected);
}

TEST(ReadArm, NamesEachViolationOfTheDynamics) {
  const std::vector<PlanCase> cases = {
      {"none", [](auto& r) { first(r).clear_dynamics(); }, "robot.arms[0].dynamics", "is missing: give mass_kg"},
      {"mass negative", [](auto& r) { first(r).mutable_dynamics()->set_mass_kg(-0.01); },
       "robot.arms[0].dynamics.mass_kg", "is -0.01, must be 0 to 1000000000 kg"},
      {"inertia NaN", [](auto& r) { first(r).mutable_dynamics()->set_moment_of_inertia_kg_m2(kNan); },
       "robot.arms[0].dynamics.moment_of_inertia_kg_m2", "is nan"},
      {"no inertia at all",
       [](auto& r) {
         first(r).mutable_dynamics()->set_mass_kg(0.0);
         first(r).mutable_dynamics()->set_moment_of_inertia_kg_m2(0.0);
       },
       "robot.arms[0].dynamics.moment_of_inertia_kg_m2", "give an inertia of 0 kg m^2 in all"},
      {"friction NaN", [](auto& r) { first(r).mutable_dynamics()->set_viscous_friction_newton_meter_seconds(kNan); },
       "robot.arms[0].dynamics.viscous_friction_newton_meter_seconds", "is nan"},
      {"friction's time", [](auto& r) { first(r).mutable_dynamics()->set_viscous_friction_newton_meter_seconds(1e11); },
       "robot.arms[0].dynamics.viscous_friction_newton_meter_seconds", "dampens the arm by"},
      {"friction's speed",
       [](auto& r) {
         first(r).mutable_dynamics()->set_viscous_friction_newton_meter_seconds(1e12);
         first(r).mutable_dynamics()->set_moment_of_inertia_kg_m2(1e9);
       },
       "robot.arms[0].dynamics.viscous_friction_newton_meter_seconds", "lets the largest torque turn the arm at"},
      {"friction negative",
       [](auto& r) { first(r).mutable_dynamics()->set_viscous_friction_newton_meter_seconds(-1.0); },
       "robot.arms[0].dynamics.viscous_friction_newton_meter_seconds", "is -1, must be 0 to"},
      {"paper's g", [](auto& r) { first(r).mutable_dynamics()->mutable_paper()->set_gravity_m_per_s2(-9.81); },
       "robot.arms[0].dynamics.paper.gravity_m_per_s2", "is -9.81"},
      {"amplitude", [](auto& r) { first(r).mutable_dynamics()->mutable_torque()->set_amplitude_newton_meters(kNan); },
       "robot.arms[0].dynamics.torque.amplitude_newton_meters", "is nan"},
      {"phase", [](auto& r) { first(r).mutable_dynamics()->mutable_torque()->set_phase_rad(1e6); },
       "robot.arms[0].dynamics.torque.phase_rad", "is 1000000"},
      {"payload gravity",
       [](auto& r) { first(r).mutable_dynamics()->mutable_torque()->set_payload_gravity_m_per_s2(-1.0); },
       "robot.arms[0].dynamics.torque.payload_gravity_m_per_s2", "is -1"},
      {"field", [](auto& r) { first(r).mutable_dynamics()->mutable_field()->set_y_m_per_s2(kInfinity); },
       "robot.arms[0].dynamics.field.y_m_per_s2", "is inf"},
      {"centre", [](auto& r) { first(r).mutable_dynamics()->mutable_field()->set_center_of_mass_m(kNan); },
       "robot.arms[0].dynamics.field.center_of_mass_m", "is nan"},
  };
  for (const PlanCase& expected : cases) expect_violation(paper_request(), expected);
}

TEST(ReadArm, EqualNamesAreOneViolation) {
  wire::PlanMotionRequest request = paper_request();
  second(request).set_name("left");
  request.mutable_tasks()->RemoveLast();
  const auto found = violations_of(request);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].field, "robot.arms[1].name");
  EXPECT_EQ(found[0].description, "is 'left' as that of arms[0], must differ");
}

TEST(ReadArm, TakesEveryNumberToItsPlace) {
  wire::PlanMotionRequest request = paper_request();
  second(request).mutable_joint_range()->set_min_rad(-1.0);
  second(request).mutable_joint_range()->set_max_rad(2.5);
  const auto parsed = parse(request);
  const Problem& problem = std::get<PlanWish>(parsed).problem;
  EXPECT_EQ(problem.arms[0].joint_range, (Interval{0.0, std::numbers::pi}));
  const Arm& arm = problem.arms[1];
  EXPECT_EQ(arm.name, "right");
  EXPECT_EQ(arm.base.position.x(), 8.0);
  EXPECT_EQ(arm.base.heading, std::numbers::pi);
  EXPECT_EQ(arm.base.rotation, Rotation::kClockwise);
  EXPECT_EQ(arm.length, 6.0);
  EXPECT_EQ(arm.radius, 1e-9);
  EXPECT_EQ(arm.joint_range, (Interval{-1.0, 2.5}));
  EXPECT_EQ(arm.inertia, 39.0);
  EXPECT_DOUBLE_EQ(arm.gravity.amplitude, 0.5 * 9.81 * 6.0);
  EXPECT_EQ(arm.payload_gravity, 9.81);
  EXPECT_EQ(std::get<Interval>(arm.torque), (Interval{-60.0, 60.0}));
  EXPECT_EQ(arm.velocity, (Interval{-2.0, 2.0}));
}

TEST(ReadArm, TakesFrictionAndTheLineOfADrive) {
  wire::PlanMotionRequest request = paper_request();
  set_line(first(request), 60.0, 3.0);
  first(request).mutable_dynamics()->set_viscous_friction_newton_meter_seconds(0.5);
  const auto parsed = parse(request);
  const Problem& problem = std::get<PlanWish>(parsed).problem;
  EXPECT_EQ(std::get<TorqueSpeedLine>(problem.arms[0].torque), (TorqueSpeedLine{60.0, 3.0}));
  EXPECT_EQ(problem.arms[0].viscous_friction, 0.5);
  EXPECT_EQ(problem.arms[1].viscous_friction, 0.0);
}

TEST(ReadArm, TellsAbsentGravityFromZeroGravity) {
  wire::PlanMotionRequest request = paper_request();
  first(request).mutable_dynamics()->mutable_paper()->set_gravity_m_per_s2(0.0);
  second(request).mutable_dynamics()->mutable_paper();
  const auto parsed = parse(request);
  const Problem& problem = std::get<PlanWish>(parsed).problem;
  EXPECT_EQ(problem.arms[0].gravity.amplitude, 0.0);
  EXPECT_DOUBLE_EQ(problem.arms[1].gravity.amplitude, 0.5 * 9.81 * 6.0);
}

TEST(ReadArm, TakesVelocityLimitsThatAreInfinite) {
  wire::PlanMotionRequest request = paper_request();
  first(request).mutable_velocity_limit()->set_min_rad_per_s(-kInfinity);
  first(request).mutable_velocity_limit()->set_max_rad_per_s(kInfinity);
  EXPECT_TRUE(violations_of(request).empty());
}

}  // namespace
}  // namespace dualarm

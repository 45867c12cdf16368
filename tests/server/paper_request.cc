#include "tests/server/paper_request.h"

#include <numbers>

namespace dualarm {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

void describe_arm(wire::Arm& arm, const std::string& name) {
  arm.set_name(name);
  arm.mutable_link()->set_length_m(6.0);
  arm.mutable_link()->set_radius_m(1e-9);
  arm.mutable_dynamics()->set_mass_kg(1.0);
  arm.mutable_dynamics()->set_moment_of_inertia_kg_m2(3.0);
  arm.mutable_torque_limit()->mutable_constant()->set_min_newton_meters(-60.0);
  arm.mutable_torque_limit()->mutable_constant()->set_max_newton_meters(60.0);
  arm.mutable_velocity_limit()->set_min_rad_per_s(-2.0);
  arm.mutable_velocity_limit()->set_max_rad_per_s(2.0);
}

void describe_task(wire::ArmTask& task, const std::string& arm, double start_degrees, double goal_degrees) {
  task.set_arm(arm);
  task.mutable_start()->set_position_rad(start_degrees * kDegree);
  task.mutable_goal()->set_position_rad(goal_degrees * kDegree);
}

void add_rest(wire::VerifyMotionRequest& request, const std::string& arm, double position) {
  wire::ArmTrajectory& trajectory = *request.add_trajectories();
  trajectory.set_arm(arm);
  for (const double time : {0.0, 1.0}) {
    trajectory.mutable_knots()->add_time_s(time);
    trajectory.mutable_knots()->add_position_rad(position);
    trajectory.mutable_knots()->add_velocity_rad_per_s(0.0);
    trajectory.mutable_knots()->add_acceleration_rad_per_s2(0.0);
    trajectory.mutable_knots()->add_torque_newton_meters(0.0);
  }
}

}  // namespace

wire::PlanMotionRequest paper_request() {
  wire::PlanMotionRequest request;
  describe_arm(*request.mutable_robot()->add_arms(), "left");
  describe_arm(*request.mutable_robot()->add_arms(), "right");
  wire::Base& right = *request.mutable_robot()->mutable_arms(1)->mutable_base();
  right.set_x_m(8.0);
  right.set_heading_rad(std::numbers::pi);
  right.set_rotation(wire::ROTATION_CLOCKWISE);
  describe_task(*request.add_tasks(), "left", 20.0, 60.0);
  describe_task(*request.add_tasks(), "right", 70.0, 20.0);
  return request;
}

wire::VerifyMotionRequest paper_verify_request() {
  const wire::PlanMotionRequest plan = paper_request();
  wire::VerifyMotionRequest request;
  *request.mutable_robot() = plan.robot();
  add_rest(request, "left", 1.0);
  add_rest(request, "right", 2.0);
  return request;
}

}  // namespace dualarm

// No number of a request escapes validation: each is replaced by NaN and by infinity in turn.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

/// Visits each number that is set, as visit(path, setter).
template <typename Visit>
void visit_numbers(Message& message, const std::string& prefix, const Visit& visit) {
  const Reflection& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const std::string path = prefix + field->name();
    const bool repeated = field->is_repeated();
    const int count = repeated ? reflection.FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      const std::string item = repeated ? path + "[" + std::to_string(i) + "]" : path;
      if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
        visit_numbers(repeated ? *reflection.MutableRepeatedMessage(&message, field, i)
                               : *reflection.MutableMessage(&message, field),
                      item + ".", visit);
      } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
        const double kept =
            repeated ? reflection.GetRepeatedDouble(message, field, i) : reflection.GetDouble(message, field);
        const auto set = [&](double value) {
          repeated ? reflection.SetRepeatedDouble(&message, field, i, value)
                   : reflection.SetDouble(&message, field, value);
        };
        visit(item, set);
        set(kept);
      }
    }
  }
}

void fill(wire::Pose& pose) {
  pose.set_x_m(1.0);
  pose.set_y_m(1.0);
  pose.set_z_m(1.0);
  pose.set_yaw_rad(1.0);
  pose.set_roll_rad(1.0);
}

void fill(wire::TorqueTable& table) {
  for (const double position : {0.0, 1.0, 2.0}) {
    table.add_position_rad(position);
    wire::TorqueTableRow& row = *table.add_rows();
    for (const double torque : {50.0, 60.0}) {
      row.add_min_newton_meters(-torque);
      row.add_max_newton_meters(torque);
    }
  }
  table.add_velocity_rad_per_s(-1.0);
  table.add_velocity_rad_per_s(1.0);
}

wire::PlanMotionRequest full_request() {
  wire::PlanMotionRequest request = paper_request();
  for (wire::Arm& arm : *request.mutable_robot()->mutable_arms()) {
    arm.mutable_base()->set_y_m(1.0);
    arm.mutable_base()->set_z_m(1.0);
    arm.mutable_joint_range()->set_min_rad(-1.0);
    arm.mutable_joint_range()->set_max_rad(3.0);
  }
  request.mutable_robot()->mutable_arms(0)->mutable_dynamics()->mutable_paper()->set_gravity_m_per_s2(9.0);
  request.mutable_robot()->mutable_arms(0)->mutable_dynamics()->set_viscous_friction_newton_meter_seconds(0.5);
  fill(*request.mutable_robot()->mutable_arms(0)->mutable_torque_limit()->mutable_table());
  auto& line = *request.mutable_robot()->mutable_arms(1)->mutable_torque_limit()->mutable_torque_speed();
  line.set_stall_torque_newton_meters(60.0);
  line.set_no_load_speed_rad_per_s(4.0);
  for (wire::ArmTask& task : *request.mutable_tasks()) {
    task.mutable_start()->set_velocity_rad_per_s(0.1);
    task.mutable_goal()->set_velocity_rad_per_s(0.1);
  }
  wire::GravityField& field = *request.mutable_robot()->mutable_arms(1)->mutable_dynamics()->mutable_field();
  field.set_x_m_per_s2(1.0);
  field.set_y_m_per_s2(-9.0);
  field.set_center_of_mass_m(2.0);
  wire::Object& ball = *request.mutable_scene()->add_objects();
  ball.set_name("ball");
  ball.mutable_sphere()->set_radius_m(0.1);
  fill(*ball.mutable_fixed());
  ball.mutable_fixed()->set_pitch_rad(1.0);
  wire::Object& load = *request.mutable_scene()->add_objects();
  load.set_name("load");
  load.mutable_capsule()->set_length_m(1.0);
  load.mutable_capsule()->set_radius_m(0.1);
  load.mutable_attached()->set_arm("left");
  load.mutable_attached()->set_mass_kg(1.0);
  fill(*load.mutable_attached()->mutable_pose_in_link());
  wire::Object& crate = *request.mutable_scene()->add_objects();
  crate.set_name("crate");
  crate.mutable_box()->set_size_x_m(1.0);
  crate.mutable_box()->set_size_y_m(1.0);
  crate.mutable_box()->set_size_z_m(1.0);
  for (const double time : {1.0, 2.0, 3.0}) {
    wire::TimedPose& timed = *crate.mutable_moving()->add_poses();
    timed.set_time_s(time);
    fill(*timed.mutable_pose());
  }
  wire::Object& post = *request.mutable_scene()->add_objects();
  post.set_name("post");
  post.mutable_cylinder()->set_length_m(1.0);
  post.mutable_cylinder()->set_radius_m(0.1);
  fill(*post.mutable_fixed());
  request.mutable_options()->set_clearance_m(0.1);
  request.mutable_options()->set_knot_period_s(0.02);
  request.mutable_options()->set_max_start_delay_s(5.0);
  return request;
}

wire::VerifyMotionRequest full_verify_request() {
  wire::VerifyMotionRequest request = paper_verify_request();
  request.set_clearance_m(0.1);
  for (wire::ArmTrajectory& trajectory : *request.mutable_trajectories()) {
    trajectory.set_start_time_s(0.5);
    trajectory.set_duration_s(0.5);
    wire::Arc& arc = *trajectory.add_arcs();
    arc.set_kind(wire::ARC_KIND_HOLD);
    arc.set_start_time_s(0.5);
    arc.set_end_time_s(1.0);
    arc.mutable_start()->set_position_rad(1.0);
    arc.mutable_end()->set_velocity_rad_per_s(1.0);
  }
  return request;
}

/// Expects a violation at exactly that place for each number and each bad value; returns how many numbers there are.
template <typename Request>
int expect_all_refused(Request request, const std::vector<double>& bad_values, const std::set<std::string>& allowed) {
  int count = 0;
  EXPECT_TRUE(violations_of(request).empty());
  visit_numbers(request, "", [&](const std::string& path, const auto& set) {
    ++count;
    for (const double bad : bad_values) {
      set(bad);
      std::set<std::string> found;
      for (const FieldViolation& violation : violations_of(request)) found.insert(violation.field);
      EXPECT_EQ(found.contains(path), !(std::isinf(bad) && allowed.contains(path))) << path << " = " << bad;
    }
  });
  return count;
}

TEST(EveryNumber, OfAPlanRequestIsRefusedWhenItIsNotFinite) {
  // Speed may be unlimited; that is the one place where an infinity has a meaning.
  const std::string first = "robot.arms[0].velocity_limit.";
  const std::string second = "robot.arms[1].velocity_limit.";
  const std::set<std::string> unlimited = {first + "max_rad_per_s", second + "max_rad_per_s"};
  EXPECT_GE(expect_all_refused(full_request(), {kNan, kInfinity}, unlimited), 98);
  EXPECT_GE(expect_all_refused(full_request(), {-kInfinity}, {first + "min_rad_per_s", second + "min_rad_per_s"}), 98);
}

TEST(EveryNumber, OfTrajectoriesToVerifyIsRefusedWhenItIsNotFinite) {
  const std::set<std::string> unlimited = {"robot.arms[0].velocity_limit.max_rad_per_s",
                                           "robot.arms[1].velocity_limit.max_rad_per_s"};
  EXPECT_GE(expect_all_refused(full_verify_request(), {kNan, kInfinity}, unlimited), 40);
}

}  // namespace
}  // namespace dualarm

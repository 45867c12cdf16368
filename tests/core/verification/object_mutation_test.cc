// A good plan among boxes, cylinders and objects that move by themselves, damaged in one way at a time, and the claim
// that the verifier must name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string_view>

#include "core/verification/verify.h"
#include "tests/core/verification/damage.h"
#include "tests/core/verification/sample_motions.h"
#include "tests/support/independent_check.h"

namespace dualarm {
namespace {

using testing::IsEmpty;

Eigen::Isometry3d pose_of(double x, double y, double yaw = 0.0) {
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

Box box_of(double x, double y, double z) { return {Eigen::Isometry3d::Identity(), {x, y, z}}; }

Cylinder upright(double radius) { return {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, radius}; }

struct Plan {
  Problem problem;
  Trajectory trajectory;
};

/// What the plan's motions are made for: the arms with what they carry.
Trajectory motion_of(const Problem& problem, std::array<double, kArmCount> start_times) {
  Problem loaded = problem;
  for (int arm = 0; arm < kArmCount; ++arm) loaded.arms[arm] = loaded_arm(problem, arm);
  return parabolic_motion(loaded, start_times);
}

/// Arm 1 carries a brick up to below a wall; a crate leaves its way just in time and then waits. Arm 2 carries a can
/// and falls from beside a post; a drum follows behind it.
Plan good_plan() {
  Plan plan;
  Problem& problem = plan.problem;
  problem = weightless_problem({20.0, 70.0}, {60.0, 20.0}, 0.1, 0.05);
  for (Arm& arm : problem.arms) arm.payload_gravity = 0.0;
  problem.objects = {
      {"brick", box_of(0.3, 0.2, 0.2), AttachedPlacement{0, pose_of(6.0, 0.0), 0.5}},
      {"can", upright(0.2), AttachedPlacement{1, pose_of(3.0, -0.1), 0.3}},
      {"wall", box_of(2.0, 0.05, 1.0), FixedPlacement{pose_of(1.2, 5.8)}},
      {"post", upright(0.2), FixedPlacement{pose_of(6.1, 6.1)}},
      {"crate", box_of(0.25, 0.25, 0.25),
       MovingPlacement{PoseTrack({{0.2, pose_of(2.6, 3.6)}, {0.9, pose_of(0.4, 3.6, 1.0)}, {3.0, pose_of(0.4, 3.6)}})}},
      {"drum", upright(0.25), MovingPlacement{PoseTrack({{1.0, pose_of(8.5, 5.0)}, {1.6, pose_of(6.6, 4.0)}})}},
  };
  plan.trajectory = motion_of(problem, {0.0, 0.8});
  return plan;
}

Object& object(Plan& plan, std::string_view name) {
  for (Object& each : plan.problem.objects) {
    if (each.name == name) return each;
  }
  throw std::invalid_argument("no such object");
}

/// Changes the poses of a moving object.
void change_track(Plan& plan, std::string_view name, const std::function<void(std::vector<TimedPose>&)>& change) {
  auto& moving = std::get<MovingPlacement>(object(plan, name).placement);
  std::vector<TimedPose> poses = moving.track.poses();
  change(poses);
  moving.track = PoseTrack(poses);
}

void shift(Plan& plan, std::string_view name, double time) {
  change_track(plan, name, [time](auto& poses) {
    for (TimedPose& pose : poses) pose.time += time;
  });
}

struct Damage {
  const char* name;
  ViolationKind kind;
  std::function<void(Plan&)> apply;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> kDamages = {
      {"AMoverLeavesLate", ViolationKind::kClearance, [](Plan& p) { shift(p, "crate", 1.0); }},
      {"AMoverComesEarly", ViolationKind::kClearance, [](Plan& p) { shift(p, "drum", -1.0); }},
      {"AMoverSkipsAPose", ViolationKind::kClearance,
       [](Plan& p) { change_track(p, "crate", [](auto& poses) { poses.erase(poses.begin() + 1); }); }},
      {"AMoverNeverComesToItsEnd", ViolationKind::kClearance,
       [](Plan& p) { change_track(p, "crate", [](auto& poses) { poses.resize(1); }); }},
      {"AMoverGoesBack", ViolationKind::kClearance,
       [](Plan& p) { change_track(p, "crate", [](auto& poses) { std::swap(poses[0].pose, poses[1].pose); }); }},
      {"AMoverEndsElsewhere", ViolationKind::kClearance,
       [](Plan& p) { change_track(p, "drum", [](auto& poses) { poses.back().pose = pose_of(3.5, 3.0); }); }},
      {"AMoverIsLarger", ViolationKind::kClearance,
       [](Plan& p) { std::get<Box>(object(p, "crate").shape).half_extents *= 4.0; }},
      {"AMoverTurnsIntoTheWay", ViolationKind::kClearance,
       [](Plan& p) { object(p, "crate").shape = box_of(0.05, 2.0, 0.05); }},
      {"AMoverStandsStill", ViolationKind::kClearance,
       [](Plan& p) { object(p, "crate").placement = FixedPlacement{pose_of(2.6, 3.6)}; }},
      {"AWallIsTurned", ViolationKind::kClearance,
       [](Plan& p) { object(p, "wall").placement = FixedPlacement{pose_of(1.2, 5.8, -0.2)}; }},
      {"AWallIsThicker", ViolationKind::kClearance,
       [](Plan& p) { std::get<Box>(object(p, "wall").shape).half_extents.y() = 0.25; }},
      {"AWallStandsNearer", ViolationKind::kClearance,
       [](Plan& p) { object(p, "wall").placement = FixedPlacement{pose_of(1.2, 5.6)}; }},
      {"APostIsWider", ViolationKind::kClearance,
       [](Plan& p) { std::get<Cylinder>(object(p, "post").shape).radius = 0.35; }},
      {"APostLeans", ViolationKind::kClearance,
       [](Plan& p) {
         object(p, "post").placement =
             FixedPlacement{pose_of(6.1, 6.1) * Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX())};
       }},
      {"APostIsABox", ViolationKind::kClearance, [](Plan& p) { object(p, "post").shape = box_of(0.4, 0.4, 1.0); }},
      {"ACarriedBoxIsLonger", ViolationKind::kClearance,
       [](Plan& p) { std::get<Box>(object(p, "brick").shape).half_extents.x() = 0.6; }},
      {"ACarriedBoxIsTurned", ViolationKind::kClearance,
       [](Plan& p) {
         std::get<Box>(object(p, "brick").shape).half_extents.z() = 1.0;
         object(p, "brick").placement =
             AttachedPlacement{0, pose_of(6.0, 0.0) * Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitY()), 0.5};
       }},
      {"ACarriedBoxIsThinner", ViolationKind::kTorqueColumn,
       [](Plan& p) { std::get<Box>(object(p, "brick").shape).half_extents.y() = 0.1; }},
      {"ACarriedCylinderIsThinner", ViolationKind::kTorqueColumn,
       [](Plan& p) { std::get<Cylinder>(object(p, "can").shape).radius = 0.1; }},
      {"TheOtherArmCarriesTheBox", ViolationKind::kTorqueColumn,
       [](Plan& p) { std::get<AttachedPlacement>(object(p, "brick").placement).arm = 1; }},
      {"ALoadIsDropped", ViolationKind::kTorqueColumn,
       [](Plan& p) { object(p, "brick").placement = FixedPlacement{pose_of(9.0, -3.0)}; }},
      {"AnArmStartsTooEarly", ViolationKind::kClearance,
       [](Plan& p) {
         p.trajectory = motion_of(p.problem, {0.0, 0.3});
       }},
      {"TheMotionsAreSwapped", ViolationKind::kEndState,
       [](Plan& p) { std::swap(p.trajectory[0].knots, p.trajectory[1].knots); }},
      {"TimeHasAGap", ViolationKind::kTorque,
       [](Plan& p) {
         std::vector<Knot>& knots = p.trajectory[0].knots;
         knots.erase(knots.begin() + 20, knots.begin() + 50);
       }},
  };
  return kDamages;
}

TEST(ObjectMutation, TheUndamagedPlanHolds) {
  const Plan plan = good_plan();
  const Verification verification = expect_to_hold(plan.problem, plan.trajectory);
  EXPECT_LT(verification.distance_query_count, 150);
  EXPECT_THAT(independent_check(plan.problem, plan.trajectory), IsEmpty());
}

class ObjectMutation : public testing::TestWithParam<Damage> {};

TEST_P(ObjectMutation, IsNamed) {
  Plan plan = good_plan();
  GetParam().apply(plan);
  expect_named(plan.problem, plan.trajectory, GetParam().kind);
}

TEST_P(ObjectMutation, IsSeenByTheIndependentCheckWhereSamplesCanSeeIt) {
  Plan plan = good_plan();
  GetParam().apply(plan);
  if (GetParam().kind != ViolationKind::kClearance && GetParam().kind != ViolationKind::kEndState) return;
  EXPECT_THAT(independent_check(plan.problem, plan.trajectory), testing::Not(IsEmpty()));
}

INSTANTIATE_TEST_SUITE_P(Damage, ObjectMutation, testing::ValuesIn(damages()),
                         [](const testing::TestParamInfo<Damage>& damage) { return damage.param.name; });

}  // namespace
}  // namespace dualarm

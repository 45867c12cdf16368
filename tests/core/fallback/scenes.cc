#include "tests/core/fallback/scenes.h"

namespace dualarm {

Problem paper_problem(JointPair from_degrees, JointPair to_degrees, double radius) {
  Problem problem;
  for (int i = 0; i < kArmCount; ++i) {
    Arm& arm = problem.arms[i];
    arm.name = i == 0 ? "left" : "right";
    arm.length = 6.0;
    arm.radius = radius;
    arm.inertia = 39.0;
    arm.gravity = paper_gravity(1.0, 6.0);
    arm.torque = Interval{-60.0, 60.0};
    arm.velocity = {-2.0, 2.0};
    problem.tasks[i] = {{from_degrees[i] * kDegree, 0.0}, {to_degrees[i] * kDegree, 0.0}};
  }
  problem.arms[1].base = {{8.0, 0.0, 0.0}, std::numbers::pi, Rotation::kClockwise};
  return problem;
}

Problem retreat_problem() { return paper_problem({10.0, 40.0}, {40.0, 10.0}); }

Object standing_ball(double x, double y) {
  FixedPlacement placement;
  placement.pose.translation() = Eigen::Vector3d(x, y, 0.0);
  return {"ball", Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.2}, placement};
}

}  // namespace dualarm

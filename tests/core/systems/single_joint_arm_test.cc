#include "core/systems/single_joint_arm.h"

#include "tests/core/phase_plane/test_arms.h"
#include "tests/core/systems/system_laws.h"

namespace dualarm {
namespace {

/// Strong, weak, weightless and upside-down arms with asymmetric drives.
struct SingleJointArms {
  static std::vector<std::shared_ptr<const System>> make() {
    std::vector<std::shared_ptr<const System>> systems;
    for (const auto& [inertia, gravity, phase, low, high] : {std::tuple{39.0, 29.43, 0.0, -60.0, 60.0},
                                                             {1.0, 1.0, 0.4, -0.7, 0.8},
                                                             {2.0, 0.0, 0.0, -1.0, 3.0},
                                                             {0.5, -4.0, 2.0, -5.0, 3.0}}) {
      Arm arm = pendulum(inertia, gravity, 1.0);
      arm.gravity.phase = phase;
      arm.torque = Interval{low, high};
      arm.joint_range = {-4.0, 5.0};
      systems.push_back(std::make_shared<SingleJointArm>(arm));
    }
    return systems;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(SingleJointArm, SystemLaws, SingleJointArms);

TEST(SingleJointArm, NeedsTheTorqueOfItsEquationOfMotion) {
  Arm arm = pendulum(4.0, 3.0, 9.0);
  arm.gravity.phase = 0.5;
  const SingleJointArm system(arm);
  EXPECT_DOUBLE_EQ(system.torque({1.2, 0.0}, -2.0), 4.0 * -2.0 + 3.0 * std::sin(0.7));
}

TEST(SingleJointArm, UsesItsWholeTorqueAtTheEndsOfItsAccelerations) {
  const SingleJointArm system(pendulum(4.0, 3.0, 9.0));
  EXPECT_DOUBLE_EQ(system.torque({0.9, 0.0}, system.acceleration(0.9, 0.0).upper), 9.0);
  EXPECT_DOUBLE_EQ(system.torque({0.9, 0.0}, system.acceleration(0.9, 0.0).lower), -9.0);
}

}  // namespace
}  // namespace dualarm

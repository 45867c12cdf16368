#pragma once

#include <array>
#include <numbers>
#include <optional>

#include "core/fallback/steering.h"
#include "core/model/problem.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// The paper's geometry and the theory's worked values (section 4): l = 6, L = 8, I = 39, |tau| <= 60, |omega| <= 2,
/// capsules of 0.05 m. From and to in degrees.
Problem paper_problem(JointPair from_degrees, JointPair to_degrees, double radius = 0.05);

/// (10, 40) -> (40, 10): no delay exists, an arm has to retreat first. No motion takes less than kRetreatBound.
Problem retreat_problem();
inline constexpr double kRetreatBound = 2.14425;  ///< s, theory section 4, for r = 0

/// A sphere of 0.2 m radius standing in the world.
Object standing_ball(double x, double y);

/// The fastest motion of an arm from rest to rest (rad).
inline std::optional<Profile> steer(const System& system, double from, double to) {
  return steer(system, JointState{from, 0.0}, JointState{to, 0.0});
}

/// The arms of a problem as systems, kept as long as this is.
class ArmSystems {
 public:
  explicit ArmSystems(const Problem& problem)
      : first_(loaded_arm(problem, 0)), second_(loaded_arm(problem, 1)), both_{&first_, &second_} {}
  ArmSystems(const ArmSystems&) = delete;
  ArmSystems& operator=(const ArmSystems&) = delete;

  const Systems& both() const { return both_; }

 private:
  SingleJointArm first_;
  SingleJointArm second_;
  Systems both_;
};

}  // namespace dualarm

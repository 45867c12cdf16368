#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>

#include "geometry/body.h"
#include "tests/support/dice.h"

namespace dualarm {

/// Kinds of bodies that the forbidden set treats apart.
enum class ShapeKind {
  kSphere,
  kLevelCapsule,
  kStandingCapsule,
  kLeaningCapsule,
  kUprightBox,
  kPlate,
  kTiltedBox,
  kUprightCylinder,
  kLyingCylinder,
  kTiltedCylinder,
};

inline constexpr ShapeKind kShapeKinds[] = {
    ShapeKind::kSphere,        ShapeKind::kLevelCapsule,  ShapeKind::kStandingCapsule, ShapeKind::kLeaningCapsule,
    ShapeKind::kUprightBox,    ShapeKind::kPlate,         ShapeKind::kTiltedBox,       ShapeKind::kUprightCylinder,
    ShapeKind::kLyingCylinder, ShapeKind::kTiltedCylinder};

inline std::string name_of(ShapeKind kind) {
  const char* names[] = {"Sphere", "LevelCapsule", "StandingCapsule", "LeaningCapsule", "UprightBox",
                         "Plate",  "TiltedBox",    "UprightCylinder", "LyingCylinder",  "TiltedCylinder"};
  return names[static_cast<int>(kind)];
}

inline Eigen::Vector3d random_direction(Dice& dice) {
  const double z = dice.between(-1.0, 1.0);
  const double angle = dice.between(-std::numbers::pi, std::numbers::pi);
  const double flat = std::sqrt(1.0 - z * z);
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

/// A shape of a kind around the origin, of up to about `size` (m).
inline Shape random_shape(ShapeKind kind, double size, Dice& dice) {
  const auto length = [&] { return dice.between(0.1, 0.5) * size; };
  const double yaw = dice.between(-std::numbers::pi, std::numbers::pi);
  const Eigen::Vector3d level(std::cos(yaw), std::sin(yaw), 0.0);
  const auto capsule = [&](const Eigen::Vector3d& half) -> Shape { return Capsule{-half, half, 0.5 * length()}; };
  const auto cylinder = [&](const Eigen::Vector3d& half) -> Shape { return Cylinder{-half, half, 0.7 * length()}; };
  Box box;
  box.pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  box.half_extents = {length(), length(), length()};
  switch (kind) {
    case ShapeKind::kSphere:
      return capsule(Eigen::Vector3d::Zero());
    case ShapeKind::kLevelCapsule:
      return capsule(length() * level);
    case ShapeKind::kStandingCapsule:
      return capsule(length() * Eigen::Vector3d::UnitZ());
    case ShapeKind::kLeaningCapsule:
      return capsule(length() * random_direction(dice));
    case ShapeKind::kUprightBox:
      // Any of its axes may be the one that stands.
      for (int turns = dice.one_of(3); turns > 0; --turns) {
        const Eigen::Matrix3d cycle = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
        box.pose.linear() = box.pose.linear() * cycle;
      }
      return box;
    case ShapeKind::kPlate:
      box.half_extents[dice.one_of(3)] = 0.0;
      return box;
    case ShapeKind::kTiltedBox:
      box.pose.linear() = Eigen::AngleAxisd(dice.between(-std::numbers::pi, std::numbers::pi), random_direction(dice))
                              .toRotationMatrix();
      return box;
    case ShapeKind::kUprightCylinder:
      return cylinder(length() * Eigen::Vector3d::UnitZ());
    case ShapeKind::kLyingCylinder:
      return cylinder(length() * level);
    case ShapeKind::kTiltedCylinder:
      return cylinder(length() * random_direction(dice));
  }
  return capsule(Eigen::Vector3d::Zero());
}

}  // namespace dualarm

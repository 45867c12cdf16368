#pragma once

#include <utility>

#include "geometry/body.h"
#include "tests/support/dice.h"

namespace dualarm {

enum class Kind { kCapsule, kBox, kCylinder };

/// Random shapes about one size (m), a good part of them hard: sizes of 0, plates, needles, specks, axes along those of
/// the world.
class RandomShapes {
 public:
  explicit RandomShapes(std::uint64_t seed) : dice_(seed) {}

  Dice& dice() { return dice_; }
  Eigen::Vector3d direction();
  Eigen::Isometry3d pose(double size);

  /// A point of the shape, on its surface as a rule.
  Eigen::Vector3d point_of(const Shape& shape);

  Shape shape(Kind kind, double size);

  /// Two shapes of which the second may be much smaller, and aligned with the first, near to it, touching it or inside.
  std::pair<Shape, Shape> pair(Kind first, Kind second, double size);

 private:
  double length(double size);
  Shape shape(Kind kind, double size, const Eigen::Isometry3d& pose);

  Dice dice_;
};

/// How far (m) the rim of a wafer of a cylinder may be from where it should be: rounding tilts so short an axis.
double rounding_of_rim(const Shape& shape);

}  // namespace dualarm

#pragma once

#include <Eigen/Core>

#include "geometry/outline.h"
#include "tests/support/dice.h"

namespace dualarm {

/// A point, a segment or a parallelogram, of up to some metres, around the origin.
inline Outline random_outline(Dice& dice) {
  const auto somewhere = [&] { return Eigen::Vector2d(dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)); };
  const Eigen::Vector2d corner = somewhere();
  const Eigen::Vector2d a = 0.5 * somewhere();
  Eigen::Vector2d b = 0.5 * somewhere();
  const int kind = dice.one_of(3);
  if (kind == 0) return outline_of({corner, corner});
  if (kind == 1) return outline_of({corner, corner + a});
  if (a.x() * b.y() - a.y() * b.x() < 0.0) b = -b;
  Outline outline;
  outline.count = 4;
  outline.corners = {corner, corner + a, corner + a + b, corner + b};
  return outline;
}

}  // namespace dualarm

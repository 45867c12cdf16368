#pragma once

#include <Eigen/Core>

namespace dualarm {

/// How far a vector of the plane lies to the left of another one, times the other's length.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A quarter turn counterclockwise.
inline Eigen::Vector2d turned_left(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace dualarm

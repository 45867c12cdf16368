#pragma once

#include <vector>

#include "geometry/body.h"
#include "geometry/interval.h"

namespace dualarm {

/// How a body moves as a parameter (an angle, a time) grows from where it is: the origin of a frame on a straight line
/// while the frame turns about a fixed direction, both at constant rates.
struct Screw {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m per unit of the parameter
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();   ///< rad per unit
  double reach = 0.0;  ///< m, upper bound on how far points of the body are from the axis of turning through the origin
};

/// A body on its way.
class Wanderer {
 public:
  virtual ~Wanderer() = default;
  virtual Shape shape_at(double parameter) const = 0;
  /// Its motion from a parameter on, the same throughout the window that is asked about.
  virtual Screw screw_at(double parameter) const = 0;
};

/// The parameters in `window` at which a wanderer comes closer than `distance` (m, >= 0) to a fixed shape: sorted
/// disjoint intervals, never too few. Free stretches are proven by advancing along them: planes between the bodies
/// bound the distance over a whole step, to second order, so that steps shrink to kLastStep of the parameter in front
/// of a collision and never leap it (B. Mirtich's conservative advancement with Newton's speed). Stretches that collide
/// are proven in the same way between capsules, and gaps of less than some kLeastGap may be missed; between other
/// shapes it is gaps during which the body turns by less than kGap rad.
std::vector<Interval> colliding_parameters(const Shape& fixed, const Wanderer& moving, double distance,
                                           Interval window);

inline constexpr double kLastStep = 1e-10;  ///< rad or s: ends lie no farther outside
inline constexpr double kLeastGap = 1e-9;   ///< rad or s
inline constexpr double kGap = 1e-2;        ///< rad

}  // namespace dualarm

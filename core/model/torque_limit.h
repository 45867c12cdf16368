#pragma once

#include <variant>
#include <vector>

#include "geometry/interval.h"

namespace dualarm {

/// The line of an electric drive: full torque at standstill, falling linearly to zero at the no-load speed (and zero
/// beyond it) in the driving quadrant, where torque and velocity have one sign; full torque when braking. The same in
/// both senses.
struct TorqueSpeedLine {
  double stall_torque = 0.0;   ///< N m, > 0
  double no_load_speed = 0.0;  ///< rad/s, > 0
  bool operator==(const TorqueSpeedLine&) const = default;
};

/// Limits on a grid of positions and velocities, bilinear in between; outside the grid the nearest edge holds.
struct TorqueTable {
  std::vector<double> positions;   ///< rad, strictly increasing, at least one
  std::vector<double> velocities;  ///< rad/s, strictly increasing, at least one
  std::vector<Interval> limits;    ///< N m, lower < upper, row by row: one row of all velocities for each position
  bool operator==(const TorqueTable&) const = default;
};

/// What torque (N m) a drive can give: the same everywhere (lower < upper), along a line, or by a table.
/// Theory, section 1 [paper, eq. 2].
using TorqueLimit = std::variant<Interval, TorqueSpeedLine, TorqueTable>;

/// Smallest and largest torque (N m) at a position (rad) and velocity (rad/s). Continuous in both.
Interval torque_limits(const TorqueLimit& limit, double position, double velocity);

/// Smallest and largest torque (N m) at any position and velocity.
Interval torque_bounds(const TorqueLimit& limit);

/// Positions (rad) and velocities (rad/s) at which the limits have a bend; between them they are bilinear. Ascending.
std::vector<double> position_bends(const TorqueLimit& limit);
std::vector<double> velocity_bends(const TorqueLimit& limit);

}  // namespace dualarm

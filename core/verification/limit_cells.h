#pragma once

#include <optional>
#include <vector>

#include "core/model/problem.h"
#include "core/model/torque_limit.h"

namespace dualarm {

/// A torque (N m) that is linear in position and linear in velocity, about a state.
struct Bilinear {
  JointState about;
  double value = 0.0;         ///< N m, there
  double per_position = 0.0;  ///< N m/rad, there
  double per_velocity = 0.0;  ///< N m s/rad, there
  double mixed = 0.0;         ///< N m s/rad2

  double at(JointState state) const;

  /// The same function about another state.
  Bilinear moved(JointState to) const;
};

Bilinear operator+(const Bilinear& left, const Bilinear& right);  ///< precondition: about the same state
Bilinear operator*(double factor, const Bilinear& function);

/// The torque limits over a box of positions (rad) and velocities (rad/s): two functions without bends, how far
/// (N m) the limits are from them at most, and the extremes (N m) of each limit and of half their width in the box.
struct LimitsOverBox {
  Bilinear lower;
  Bilinear upper;
  double lower_error = 0.0;
  double upper_error = 0.0;
  Interval lower_extremes;
  Interval upper_extremes;
  Interval half_width_extremes;
};

/// The cells that the bends of torque limits cut the plane of positions and velocities into.
class LimitCells {
 public:
  explicit LimitCells(const TorqueLimit& limit);

  Interval at(JointState state) const { return torque_limits(limit_, state.position, state.velocity); }

  /// The limits over a box, as those of the cell in which `about` lies, continued beyond it. The errors are exact: over
  /// what a cell and the box share, a limit and its continuation are both bilinear, so that they differ most at a
  /// corner. Nothing if the box spans so many bends that it is better cut into smaller ones first.
  std::optional<LimitsOverBox> over(Interval positions, Interval velocities, JointState about) const;

 private:
  TorqueLimit limit_;
  std::vector<double> positions_;  // rad, of bends
  std::vector<double> velocities_;
};

}  // namespace dualarm

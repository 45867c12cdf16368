#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/model/arm.h"

namespace dualarm {

/// The judges' own equation of motion of one arm, I theta'' = tau - G sin(theta - phi) - b theta', and its own reading
/// of torque limits. Takes nothing from core but the numbers of the Arm. Real is double for searches, long double for
/// verdicts. Theory, section 1.
template <typename Real>
class OwnEquation {
 public:
  explicit OwnEquation(const Arm& arm) : arm_(arm) {}

  /// N m that hold the arm in a state, without acceleration.
  Real holding_torque(Real position, Real velocity) const {
    return Real(arm_.gravity.amplitude) * std::sin(position - Real(arm_.gravity.phase)) +
           Real(arm_.viscous_friction) * velocity;
  }

  /// N m for an acceleration in rad/s2.
  Real torque_for(Real position, Real velocity, Real acceleration) const {
    return Real(arm_.inertia) * acceleration + holding_torque(position, velocity);
  }

  /// Smallest and largest torque of the drive, N m.
  std::pair<Real, Real> torques(Real position, Real velocity) const {
    if (const auto* constant = std::get_if<Interval>(&arm_.torque)) return {constant->lower, constant->upper};
    if (const auto* table = std::get_if<TorqueTable>(&arm_.torque)) return from_table(*table, position, velocity);
    const auto& line = std::get<TorqueSpeedLine>(arm_.torque);
    const Real stall = line.stall_torque;
    const Real left = std::max(Real(0), Real(1) - std::abs(velocity) / Real(line.no_load_speed)) * stall;
    return {velocity < 0 ? -left : -stall, velocity > 0 ? left : stall};
  }

  /// Acceleration (rad/s2) under the largest torque (sense > 0) or the smallest.
  Real acceleration(int sense, Real position, Real velocity) const {
    const auto [lowest, highest] = torques(position, velocity);
    return ((sense > 0 ? highest : lowest) - holding_torque(position, velocity)) / Real(arm_.inertia);
  }

 private:
  /// Weights of the two grid lines around a value that is clamped to the grid.
  struct Share {
    std::size_t line = 0;
    Real beyond = 0;
  };

  static Share share(const std::vector<double>& grid, Real value) {
    std::size_t line = 0;
    while (line + 1 < grid.size() && Real(grid[line + 1]) <= value) ++line;
    if (line + 1 == grid.size() || value <= Real(grid[0])) return {line, 0};
    return {line, (value - Real(grid[line])) / (Real(grid[line + 1]) - Real(grid[line]))};
  }

  static std::pair<Real, Real> from_table(const TorqueTable& table, Real position, Real velocity) {
    const Share row = share(table.positions, position);
    const Share column = share(table.velocities, velocity);
    std::pair<Real, Real> sum = {0, 0};
    for (const std::size_t i : {0, 1}) {
      for (const std::size_t j : {0, 1}) {
        const Real weight = (i == 0 ? 1 - row.beyond : row.beyond) * (j == 0 ? 1 - column.beyond : column.beyond);
        if (weight == 0) continue;
        const Interval& at = table.limits[(row.line + i) * table.velocities.size() + column.line + j];
        sum = {sum.first + weight * Real(at.lower), sum.second + weight * Real(at.upper)};
      }
    }
    return sum;
  }

  const Arm& arm_;
};

}  // namespace dualarm

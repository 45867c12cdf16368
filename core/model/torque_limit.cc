#include "core/model/torque_limit.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

Interval mix(Interval from, Interval to, double share) {
  return {std::lerp(from.lower, to.lower, share), std::lerp(from.upper, to.upper, share)};
}

/// The cell of a grid that holds a value: the index of its lower end, and how far the value is on its way to the next.
struct Cell {
  std::size_t index = 0;
  double share = 0.0;
};

Cell cell_of(const std::vector<double>& grid, double value) {
  if (!(value > grid.front())) return {0, 0.0};
  if (value >= grid.back()) return {grid.size() - 1, 0.0};
  const auto above = std::upper_bound(grid.begin(), grid.end(), value);
  const double from = *(above - 1);
  return {static_cast<std::size_t>(above - grid.begin()) - 1, (value - from) / (*above - from)};
}

Interval limits_at(const TorqueTable& table, double position, double velocity) {
  const Cell row = cell_of(table.positions, position);
  const Cell column = cell_of(table.velocities, velocity);
  const auto in_row = [&](std::size_t index) {
    const Interval& from = table.limits[index * table.velocities.size() + column.index];
    return column.share == 0.0 ? from : mix(from, *(&from + 1), column.share);
  };
  return row.share == 0.0 ? in_row(row.index) : mix(in_row(row.index), in_row(row.index + 1), row.share);
}

Interval limits_at(const TorqueSpeedLine& line, double velocity) {
  const double driving = line.stall_torque * std::max(0.0, 1.0 - std::abs(velocity) / line.no_load_speed);
  if (velocity > 0.0) return {-line.stall_torque, driving};
  return {-driving, line.stall_torque};
}

}  // namespace

Interval torque_limits(const TorqueLimit& limit, double position, double velocity) {
  if (const auto* constant = std::get_if<Interval>(&limit)) return *constant;
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) return limits_at(*line, velocity);
  return limits_at(std::get<TorqueTable>(limit), position, velocity);
}

Interval torque_bounds(const TorqueLimit& limit) {
  if (const auto* constant = std::get_if<Interval>(&limit)) return *constant;
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) return {-line->stall_torque, line->stall_torque};
  const std::vector<Interval>& limits = std::get<TorqueTable>(limit).limits;
  Interval bounds = limits.front();
  for (const Interval& here : limits) {
    bounds = {std::min(bounds.lower, here.lower), std::max(bounds.upper, here.upper)};
  }
  return bounds;
}

std::vector<double> position_bends(const TorqueLimit& limit) {
  const auto* table = std::get_if<TorqueTable>(&limit);
  return table == nullptr ? std::vector<double>{} : table->positions;
}

std::vector<double> velocity_bends(const TorqueLimit& limit) {
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) return {-line->no_load_speed, 0.0, line->no_load_speed};
  const auto* table = std::get_if<TorqueTable>(&limit);
  return table == nullptr ? std::vector<double>{} : table->velocities;
}

}  // namespace dualarm

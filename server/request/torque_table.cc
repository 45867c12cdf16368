#include "server/request/torque_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

using Column = google::protobuf::RepeatedField<double>;

/// The values of a grid, which have to ascend; nothing if there are none or too many.
std::vector<double> read_grid(const Column& column, std::string_view name, const Range& range, const Field& table) {
  if (column.empty() || column.size() > table.limits().table_lines) {
    table.complain(name, fmt::format("has {} entries, must have 1 to {}", column.size(), table.limits().table_lines));
    return {};
  }
  for (int k = 0; k < column.size(); ++k) {
    const std::string here = fmt::format("{}[{}]", name, k);
    table.number(here, column[k], range);
    if (k > 0 && column[k] <= column[k - 1]) {
      table.complain(here, fmt::format("is {}, must exceed {}[{}] = {}", column[k], name, k - 1, column[k - 1]));
    }
  }
  return {column.begin(), column.end()};
}

bool has_length(const Column& column, std::string_view name, std::size_t length, const Field& row) {
  if (static_cast<std::size_t>(column.size()) == length) return true;
  row.complain(name, fmt::format("has {} entries, must have {} as velocity_rad_per_s has", column.size(), length));
  return false;
}

void read_row(const wire::TorqueTableRow& message, const Field& row, std::size_t length,
              std::vector<Interval>& limits) {
  const bool fits_below = has_length(message.min_newton_meters(), "min_newton_meters", length, row);
  const bool fits_above = has_length(message.max_newton_meters(), "max_newton_meters", length, row);
  if (!fits_below || !fits_above) return;
  for (int k = 0; k < static_cast<int>(length); ++k) {
    const Interval limit = {message.min_newton_meters(k), message.max_newton_meters(k)};
    const bool in_range = ranges::kTorque.contains(limit.lower) && ranges::kTorque.contains(limit.upper);
    if (!in_range || limit.lower >= limit.upper) {
      row.number(fmt::format("min_newton_meters[{}]", k), limit.lower, ranges::kTorque);
      row.number(fmt::format("max_newton_meters[{}]", k), limit.upper, ranges::kTorque);
    }
    if (limit.lower >= limit.upper) {
      row.complain(fmt::format("max_newton_meters[{}]", k),
                   fmt::format("is {}, must exceed min_newton_meters[{}] = {}", limit.upper, k, limit.lower));
    }
    if (in_range) limits.push_back(limit);
  }
}

/// Whether there is a row for each position, and not more in all than is served.
bool has_rows(const wire::TorqueTable& message, const TorqueTable& grid, const Field& table) {
  const std::size_t rows = grid.positions.size();
  const std::size_t columns = grid.velocities.size();
  if (static_cast<std::size_t>(message.rows_size()) != rows) {
    table.complain("rows", fmt::format("has {} entries, must have {} as position_rad has", message.rows_size(), rows));
    return false;
  }
  if (rows * columns > static_cast<std::size_t>(table.limits().table_entries)) {
    table.complain(
        fmt::format("has {} positions times {} velocities = {} entries, must have at most {} in all: thin "
                    "the grid out where the limits are straight",
                    rows, columns, rows * columns, table.limits().table_entries));
    return false;
  }
  return true;
}

/// Change of a limit over the step from one velocity of a table to the next, N m s, at the steepest of its positions.
double steepest(const TorqueTable& table, std::size_t step) {
  const std::size_t columns = table.velocities.size();
  double change = 0.0;
  for (std::size_t entry = step; entry < table.limits.size(); entry += columns) {
    const Interval& before = table.limits[entry - 1];
    const Interval& after = table.limits[entry];
    change = std::max({change, std::abs(after.lower - before.lower), std::abs(after.upper - before.upper)});
  }
  return change / (table.velocities[step] - table.velocities[step - 1]);
}

}  // namespace

void check_steepness(const TorqueTable& read, double inertia, const Field& table) {
  for (std::size_t step = 1; step < read.velocities.size(); ++step) {
    const double rate = steepest(read, step) / inertia;
    if (rate <= ranges::kSteepestTable) continue;
    table.complain(
        fmt::format("velocity_rad_per_s[{}]", step),
        fmt::format("is {}, so close to velocity_rad_per_s[{}] = {} that limits change by {} 1/s between them "
                    "at an inertia of {} kg m^2, must be at most {} 1/s: move them apart",
                    read.velocities[step], step - 1, read.velocities[step - 1], rate, inertia, ranges::kSteepestTable));
  }
}

TorqueLimit read_torque_table(const wire::TorqueTable& message, const Field& table) {
  TorqueTable read;
  read.positions = read_grid(message.position_rad(), "position_rad", ranges::kAngle, table);
  read.velocities = read_grid(message.velocity_rad_per_s(), "velocity_rad_per_s", ranges::kVelocity, table);
  if (read.positions.empty() || read.velocities.empty() || !has_rows(message, read, table)) return {};
  read.limits.reserve(read.positions.size() * read.velocities.size());
  for (int i = 0; i < message.rows_size(); ++i) {
    read_row(message.rows(i), table.child("rows", i), read.velocities.size(), read.limits);
  }
  if (read.limits.size() != read.positions.size() * read.velocities.size()) return {};
  return read;
}

}  // namespace dualarm

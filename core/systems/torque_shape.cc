#include "core/systems/torque_shape.h"

#include <algorithm>

namespace dualarm {
namespace {

/// Whether a statement about a velocity in a direction, the torque there and the torque at standstill holds at some
/// point of a table's grid. Between the points the torque is bilinear. False for limits without a table.
template <class Statement>
bool holds_on_grid(const TorqueLimit& limit, Extreme extreme, double direction, const Statement& statement) {
  const auto* table = std::get_if<TorqueTable>(&limit);
  if (table == nullptr) return false;
  auto limits = table->limits.begin();
  for (const double position : table->positions) {
    const double at_rest = torque_end(extreme, torque_limits(limit, position, 0.0));
    for (const double velocity : table->velocities) {
      const double torque = torque_end(extreme, *limits++);
      if (velocity * direction > 0.0 && statement(velocity, torque, at_rest)) return true;
    }
  }
  return false;
}

}  // namespace

PiecewiseLinear torque_at_velocity(const TorqueLimit& limit, Extreme extreme, double velocity, Interval within) {
  const auto* table = std::get_if<TorqueTable>(&limit);
  if (table == nullptr) return PiecewiseLinear(torque_end(extreme, torque_limits(limit, 0.0, velocity)));
  // From the last row at or before `within` to the first behind it.
  const std::vector<double>& rows = table->positions;
  auto first = std::upper_bound(rows.begin(), rows.end(), within.lower);
  if (first != rows.begin()) --first;
  auto last = std::lower_bound(first, rows.end(), within.upper);
  if (last != rows.end()) ++last;
  const std::vector<double> knots(first, last);
  std::vector<double> torques;
  torques.reserve(knots.size());
  for (const double position : knots) {
    torques.push_back(torque_end(extreme, torque_limits(limit, position, velocity)));
  }
  return {knots, torques};
}

bool torque_depends_on_velocity(const TorqueLimit& limit, Extreme extreme, double direction) {
  if (std::holds_alternative<TorqueSpeedLine>(limit)) return extreme == driving_extreme(direction);
  const auto differs = [](double /*velocity*/, double torque, double at_rest) { return torque != at_rest; };
  return holds_on_grid(limit, extreme, direction, differs);
}

bool torque_drives_best_at_rest(const TorqueLimit& limit, double friction, double direction) {
  const auto is_stronger = [=](double velocity, double torque, double at_rest) {
    return (torque - friction * velocity - at_rest) * direction > 0.0;
  };
  return !holds_on_grid(limit, driving_extreme(direction), direction, is_stronger);
}

}  // namespace dualarm

#include "core/verification/limit_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

/// Corners of cells inside of a box, up to which looking at each is cheaper than cutting the box.
constexpr std::ptrdiff_t kMostCorners = 36;

/// The stretch between two bends that holds a value. Beyond the outermost bends nothing changes: one of no length.
Interval stretch_of(const std::vector<double>& bends, double value) {
  if (bends.empty()) return {value, value};
  if (!(value >= bends.front())) return {bends.front(), bends.front()};
  if (value >= bends.back()) return {bends.back(), bends.back()};
  const auto above = std::upper_bound(bends.begin(), bends.end(), value);
  return {*(above - 1), *above};
}

/// The bends strictly between the ends of an interval.
struct Bends {
  std::vector<double>::const_iterator begin;
  std::vector<double>::const_iterator end;
};

Bends bends_inside(const std::vector<double>& bends, Interval within) {
  const auto begin = std::upper_bound(bends.begin(), bends.end(), within.lower);
  return {begin, std::lower_bound(begin, bends.end(), within.upper)};
}

/// Calls visit with both ends of an interval and with the bends in between.
template <typename Visit>
void for_each_corner(Interval within, Bends bends, Visit visit) {
  visit(within.lower);
  std::for_each(bends.begin, bends.end, visit);
  visit(within.upper);
}

double over_length(double change, Interval stretch) { return stretch.length() > 0.0 ? change / stretch.length() : 0.0; }

void include(Interval& extremes, double value) {
  extremes = {std::min(extremes.lower, value), std::max(extremes.upper, value)};
}

}  // namespace

double Bilinear::at(JointState state) const {
  const double ahead = state.position - about.position;
  const double faster = state.velocity - about.velocity;
  return value + per_position * ahead + per_velocity * faster + mixed * ahead * faster;
}

Bilinear Bilinear::moved(JointState to) const {
  return {to, at(to), per_position + mixed * (to.velocity - about.velocity),
          per_velocity + mixed * (to.position - about.position), mixed};
}

Bilinear operator+(const Bilinear& left, const Bilinear& right) {
  return {left.about, left.value + right.value, left.per_position + right.per_position,
          left.per_velocity + right.per_velocity, left.mixed + right.mixed};
}

Bilinear operator*(double factor, const Bilinear& function) {
  return {function.about, factor * function.value, factor * function.per_position, factor * function.per_velocity,
          factor * function.mixed};
}

LimitCells::LimitCells(const TorqueLimit& limit)
    : limit_(limit), positions_(position_bends(limit)), velocities_(velocity_bends(limit)) {}

std::optional<LimitsOverBox> LimitCells::over(Interval positions, Interval velocities, JointState about) const {
  const Interval cell_positions = stretch_of(positions_, about.position);
  const Interval cell_velocities = stretch_of(velocities_, about.velocity);
  const JointState corner = {cell_positions.lower, cell_velocities.lower};
  const Interval here = at(corner);
  const Interval ahead = at({cell_positions.upper, cell_velocities.lower});
  const Interval faster = at({cell_positions.lower, cell_velocities.upper});
  const Interval across = at({cell_positions.upper, cell_velocities.upper});
  const auto through = [&](double Interval::*end) {
    const double mixed =
        over_length(over_length(across.*end - ahead.*end - faster.*end + here.*end, cell_positions), cell_velocities);
    return Bilinear{corner, here.*end, over_length(ahead.*end - here.*end, cell_positions),
                    over_length(faster.*end - here.*end, cell_velocities), mixed};
  };
  const Bilinear lower = through(&Interval::lower).moved(about);
  const Bilinear upper = through(&Interval::upper).moved(about);

  const Bends rows = bends_inside(positions_, positions);
  const Bends columns = bends_inside(velocities_, velocities);
  if ((rows.end - rows.begin + 2) * (columns.end - columns.begin + 2) > kMostCorners) return std::nullopt;
  constexpr Interval kNone = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  LimitsOverBox over = {lower, upper, 0.0, 0.0, kNone, kNone, kNone};
  for_each_corner(positions, rows, [&](double position) {
    for_each_corner(velocities, columns, [&](double velocity) {
      const Interval limits = at({position, velocity});
      over.lower_error = std::max(over.lower_error, std::abs(limits.lower - lower.at({position, velocity})));
      over.upper_error = std::max(over.upper_error, std::abs(limits.upper - upper.at({position, velocity})));
      include(over.lower_extremes, limits.lower);
      include(over.upper_extremes, limits.upper);
      include(over.half_width_extremes, 0.5 * limits.length());
    });
  });
  return over;
}

}  // namespace dualarm

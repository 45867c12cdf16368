#include "core/fallback/profile_table.h"

#include <algorithm>

namespace dualarm {
namespace {

/// Pieces an arc is cut into: the quintic is then within 1e-8 rad of a swing of a radian (tested).
constexpr int kPiecesPerArc = 16;

/// Position on the quintic that takes position, velocity and acceleration from both knots.
double quintic(const Knot& from, const Knot& to, double time) {
  const double span = to.time - from.time;
  const double u = (time - from.time) / span;
  const double v0 = from.velocity * span;
  const double v1 = to.velocity * span;
  const double a0 = 0.5 * from.acceleration * span * span;
  const double a1 = 0.5 * to.acceleration * span * span;
  const double rise = to.position - from.position;
  const double c3 = 10.0 * rise - 6.0 * v0 - 4.0 * v1 - 3.0 * a0 + a1;
  const double c4 = -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 3.0 * a0 - 2.0 * a1;
  const double c5 = 6.0 * rise - 3.0 * (v0 + v1) - a0 + a1;
  return from.position + u * (v0 + u * (a0 + u * (c3 + u * (c4 + u * c5))));
}

}  // namespace

ProfileTable::ProfileTable(const Profile& profile) {
  for (const Arc& arc : profile.arcs()) {
    const int pieces = arc.kind == ArcKind::kCruise ? 1 : kPiecesPerArc;
    const std::vector<JointState> states = profile.states_along(arc, pieces);
    for (int i = 0; i <= pieces; ++i) {
      const double time = arc.start_time + (arc.end_time - arc.start_time) * i / pieces;
      const double acceleration = profile.acceleration_on(arc, states[i]);
      knots_.push_back({time, states[i].position, states[i].velocity, acceleration, 0.0});
    }
  }
  if (knots_.empty()) knots_.push_back({0.0, profile.start(), 0.0, 0.0, 0.0});
}

double ProfileTable::position(double time) const {
  if (time <= knots_.front().time) return knots_.front().position;
  if (time >= knots_.back().time) return knots_.back().position;
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), time,
                                      [](double value, const Knot& knot) { return value < knot.time; });
  return quintic(*(after - 1), *after, time);
}

}  // namespace dualarm

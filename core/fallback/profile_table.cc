#include "core/fallback/profile_table.h"

#include <algorithm>
#include <cmath>

namespace dualarm {
namespace {

/// Pieces an arc is cut into at first, and at most: where its acceleration has bends or changes fast, pieces are
/// halved.
constexpr int kPiecesPerArc = 6;
constexpr int kMostPieces = 2048;

/// rad: how far a quintic may be from the exact motion, judged by its acceleration inside the piece.
constexpr double kPositionError = 1e-8;

/// Where in a piece the acceleration is looked at, and what a difference there, times the span's square, makes in the
/// position at most: 1/24 in the middle of a piece whose error is as smooth as can be.
constexpr double kLooks[] = {0.25, 0.5, 0.75};
constexpr double kShareInPosition = 1.0 / 24.0;

/// The quintic that takes position, velocity and acceleration from both knots.
class Quintic {
 public:
  Quintic(const Knot& from, const Knot& to) : start_(from.position), span_(to.time - from.time) {
    v0_ = from.velocity * span_;
    a0_ = 0.5 * from.acceleration * span_ * span_;
    const double v1 = to.velocity * span_;
    const double a1 = 0.5 * to.acceleration * span_ * span_;
    const double rise = to.position - from.position;
    c3_ = 10.0 * rise - 6.0 * v0_ - 4.0 * v1 - 3.0 * a0_ + a1;
    c4_ = -15.0 * rise + 8.0 * v0_ + 7.0 * v1 + 3.0 * a0_ - 2.0 * a1;
    c5_ = 6.0 * rise - 3.0 * (v0_ + v1) - a0_ + a1;
  }

  double position(double u) const { return start_ + u * (v0_ + u * (a0_ + u * (c3_ + u * (c4_ + u * c5_)))); }
  double velocity(double u) const {
    return (v0_ + u * (2.0 * a0_ + u * (3.0 * c3_ + u * (4.0 * c4_ + u * 5.0 * c5_)))) / span_;
  }
  double acceleration(double u) const {
    return (2.0 * a0_ + u * (6.0 * c3_ + u * (12.0 * c4_ + u * 20.0 * c5_))) / (span_ * span_);
  }

 private:
  double start_;
  double span_;
  double v0_;
  double a0_;
  double c3_;
  double c4_;
  double c5_;
};

std::vector<Knot> knots_along(const Profile& profile, const Arc& arc, int pieces) {
  std::vector<Knot> knots;
  for (const JointState& state : profile.states_along(arc, pieces)) {
    const double time = arc.start_time + (arc.end_time - arc.start_time) * static_cast<double>(knots.size()) / pieces;
    knots.push_back({time, state.position, state.velocity, profile.acceleration_on(arc, state), 0.0});
  }
  knots.back().time = arc.end_time;  // which rounding may have missed
  return knots;
}

bool is_faithful(const Profile& profile, const Arc& arc, const std::vector<Knot>& knots) {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Quintic quintic(knots[i], knots[i + 1]);
    const double span = knots[i + 1].time - knots[i].time;
    for (const double u : kLooks) {
      const double exact = profile.acceleration_on(arc, {quintic.position(u), quintic.velocity(u)});
      const double error = std::abs(quintic.acceleration(u) - exact);
      if (kShareInPosition * error * span * span > kPositionError) return false;
    }
  }
  return true;
}

}  // namespace

ProfileTable::ProfileTable(const Profile& profile) {
  for (const Arc& arc : profile.arcs()) {
    int pieces = arc.kind == ArcKind::kCruise ? 1 : kPiecesPerArc;
    std::vector<Knot> knots = knots_along(profile, arc, pieces);
    while (2 * pieces <= kMostPieces && !is_faithful(profile, arc, knots)) {
      pieces *= 2;
      knots = knots_along(profile, arc, pieces);
    }
    knots_.insert(knots_.end(), knots.begin(), knots.end());
  }
  if (knots_.empty()) knots_.push_back({0.0, profile.start(), 0.0, 0.0, 0.0});
  for (std::size_t leg = 1; leg < profile.legs().size(); ++leg)
    turning_times_.push_back(profile.legs()[leg].start_time);
}

double ProfileTable::position(double time) const {
  if (time <= knots_.front().time) return knots_.front().position;
  if (time >= knots_.back().time) return knots_.back().position;
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), time,
                                      [](double value, const Knot& knot) { return value < knot.time; });
  const Knot& before = *(after - 1);
  return Quintic(before, *after).position((time - before.time) / (after->time - before.time));
}

}  // namespace dualarm

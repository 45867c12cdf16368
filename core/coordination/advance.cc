#include "core/coordination/advance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "geometry/clearance.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

/// Steps along one free stretch after which what follows counts as a collision. A transversal one takes less than ten,
/// passing by at 1e-12 m some fifty.
constexpr int kMostSteps = 400;
constexpr double kJustInside = 1.0 - 1e-9;
/// Chords and halvings by which the length of one step is sought; each can only be too short.
constexpr int kChords = 4;
/// Tangents by which a stretch of collision is sought, likewise.
constexpr int kTangents = 4;

/// Sizes of two bodies from which on the way between their centres is as good as that between nearest points.
constexpr double kAfar = 2.0;

/// What one look at two bodies proves.
struct Look {
  double slack = 0.0;    ///< m, distance beyond the asked one, proven; not above 0 where they collide or nearly
  double stretch = 0.0;  ///< of the parameter, without collision; 0 where slack is not above 0
};

/// The distance beyond the asked one along a normal that stays: concave in the parameter, and a lower bound.
class Gap {
 public:
  Gap(const Shape& fixed, const Shape& moving, const Screw& screw, const Eigen::Vector3d& normal, double distance)
      : moving_(moving),
        normal_(normal),
        tilt_(normal.cross(screw.turning)),
        drift_(normal.dot(screw.velocity) - tilt_.dot(screw.origin)),
        bend_(screw.turning.squaredNorm() * screw.reach),
        needed_(normal.dot(farthest_point(fixed, normal)) + distance),
        at_start_(at(0.0)),
        slope_(tilt_.dot(farthest_point(moving, -normal)) + drift_) {}

  /// At a parameter >= 0 from where the bodies are.
  double at(double parameter) const {
    const Eigen::Vector3d seen = normal_ + parameter * tilt_;
    return seen.dot(farthest_point(moving_, -seen)) + parameter * drift_ - 0.5 * bend_ * parameter * parameter -
           needed_;
  }

  double at_start() const { return at_start_; }

  /// Where the point that is nearest now would end it, just inside: the others can only end it earlier.
  double latest_end() const {
    const double root = std::sqrt(slope_ * slope_ + 2.0 * bend_ * std::max(0.0, at_start_));
    const double closing = root - slope_;  // 2 at_start / closing is the root without cancellation where slope < 0
    if (closing <= 0.0) return std::numeric_limits<double>::infinity();
    return kJustInside * (slope_ < 0.0 || bend_ == 0.0 ? 2.0 * at_start_ / closing : (slope_ + root) / bend_);
  }

 private:
  const Shape& moving_;
  Eigen::Vector3d normal_;
  Eigen::Vector3d tilt_;  ///< how fast the normal turns for the body, which turns itself
  double drift_;          ///< m per unit
  double bend_;           ///< m per unit squared
  double needed_;         ///< m
  double at_start_;       ///< m
  double slope_;          ///< m per unit, at the start
};

/// As far as `gap` is proven to be positive, from where it is.
double stretch_of(const Gap& gap, double longest) {
  double good = 0.0;
  double at_good = gap.at(0.0);
  double bad = std::min(longest, gap.latest_end());
  double at_bad = gap.at(bad);
  if (at_bad >= 0.0) return bad;
  for (int i = 0; i < kChords; ++i) {
    const double middle = 0.5 * (good + bad);
    for (const double next : {good + (bad - good) * at_good / (at_good - at_bad), middle}) {
      if (!(next > good) || !(next < bad)) continue;
      const double value = gap.at(next);
      (value >= 0.0 ? good : bad) = next;
      (value >= 0.0 ? at_good : at_bad) = value;
    }
  }
  return good;
}

/// How two points are apart as one of them goes on its way: at most |way + rate t| + bend t^2 / 2.
struct PointsApart {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();   ///< m
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();  ///< m per unit of the parameter
  double bend = 0.0;                               ///< m per unit squared

  double at(double parameter) const { return (way + parameter * rate).norm() + 0.5 * bend * parameter * parameter; }

  double slope(double parameter) const {
    const Eigen::Vector3d now = way + parameter * rate;
    return (now.isZero(0.0) ? rate.norm() : now.dot(rate) / now.norm()) + bend * parameter;
  }

  /// As long (of the parameter, at most `longest`) as they are proven to be within a distance. What bounds them is
  /// convex: it passes the distance once, later than its chord from the start does and earlier than its tangents do.
  double are_within(double distance, double longest) const {
    const double room = distance - at(0.0);
    if (!(room > 0.0)) return 0.0;
    if (at(longest) <= distance) return longest;
    const double closing = slope(0.0) + std::sqrt(slope(0.0) * slope(0.0) + 2.0 * bend * room);
    double beyond = closing > 0.0 ? std::min(longest, 2.0 * room / closing) : longest;
    for (int i = 0; i < kTangents; ++i) beyond -= std::max(0.0, at(beyond) - distance) / slope(beyond);
    return std::min(beyond, beyond * room / (at(beyond) - at(0.0)));
  }
};

class Advance {
 public:
  Advance(const Shape& fixed, const Wanderer& moving, double distance, Interval window)
      : fixed_(fixed), moving_(moving), distance_(distance), window_(window) {}

  std::vector<Interval> run() const {
    std::vector<Interval> found;
    double from = window_.lower;
    while (true) {
      const double begin = end_of_free(from, 1.0, window_.upper);
      if (begin > window_.upper) return found;
      const double free = next_free(begin);
      if (free > window_.upper) {
        found.push_back({begin, window_.upper});
        return found;
      }
      found.push_back({begin, std::max(begin, end_of_free(free, -1.0, begin))});
      if (free == window_.upper) return found;
      from = free;
    }
  }

 private:
  /// Forwards (1) or backwards (-1), over at most `longest`.
  Look look(double parameter, double direction, double longest) const {
    const Shape placed = moving_.shape_at(parameter);
    const Look from_afar = look_from_afar(placed, parameter, direction, longest);
    if (from_afar.slack > 0.0) return from_afar;
    const Clearance seen = clearance(fixed_, placed);
    const Eigen::Vector3d across = seen.point_on_second - seen.point_on_first;
    if (!(seen.distance > distance_) || across.norm() == 0.0) return {std::min(0.0, seen.distance - distance_), 0.0};
    return look_along(across.normalized(), placed, parameter, direction, longest);
  }

  /// From centre to centre, without asking for the distance; nothing where the bodies are too close for that.
  Look look_from_afar(const Shape& placed, double parameter, double direction, double longest) const {
    const Eigen::Vector3d across = centre(placed) - centre(fixed_);
    const double size = bounding_radius(placed) + bounding_radius(fixed_) + distance_;
    if (!(across.norm() > kAfar * size)) return {};
    return look_along(across.normalized(), placed, parameter, direction, longest);
  }

  /// What a plane at right angles to a normal proves.
  Look look_along(const Eigen::Vector3d& normal, const Shape& placed, double parameter, double direction,
                  double longest) const {
    Screw screw = moving_.screw_at(parameter);
    screw.velocity *= direction;
    screw.turning *= direction;
    const Gap gap(fixed_, placed, screw, normal, distance_);
    if (!(gap.at_start() > 0.0)) return {0.0, 0.0};
    return {gap.at_start(), longest > 0.0 ? stretch_of(gap, longest) : 0.0};
  }

  /// From a parameter as far as nothing collides; beyond `limit` (forwards only) where it does nowhere.
  double end_of_free(double from, double direction, double limit) const {
    for (int step = 0; step < kMostSteps; ++step) {
      const double left = std::abs(limit - from);
      const Look seen = look(from, direction, left);
      if (!(seen.slack > 0.0)) return from;
      if (seen.stretch >= left) return direction > 0.0 ? std::numeric_limits<double>::infinity() : limit;
      if (seen.stretch < kLastStep) return from;
      from += direction * seen.stretch;
    }
    return from;
  }

  /// The first parameter after a collision that is seen to be free, by looking; beyond the window if none is. Between
  /// looks the bodies are proven to collide, but for short steps over the end of what can be proven; these grow where
  /// the end is not met for long.
  double next_free(double from) const {
    const double turning = moving_.screw_at(from).turning.norm();
    // The distance to convex bodies that do not turn has no second minimum.
    const double longest = turning > 0.0 ? kGap / turning : std::numeric_limits<double>::infinity();
    const bool is_proven = turning > 0.0 && std::holds_alternative<Capsule>(fixed_) &&
                           std::holds_alternative<Capsule>(moving_.shape_at(from));
    double least = is_proven ? kLeastGap : longest;
    for (int step = 0;; ++step) {
      if (step > kMostSteps) least = std::min(2.0 * least, longest);
      const double proven = is_proven ? collides_for(from, window_.upper - from) : 0.0;
      const double next = std::min(from + std::max(proven, least), window_.upper);
      if (look(next, 1.0, 0.0).slack > 0.0) return next;
      if (next == window_.upper) return std::numeric_limits<double>::infinity();
      from = next;
    }
  }

  /// How far from a parameter on two capsules go on to collide: at least as long as two points of their axes, the
  /// nearest ones now, are closer than their surfaces may be.
  double collides_for(double parameter, double longest) const {
    Capsule its = std::get<Capsule>(fixed_);
    Capsule others = std::get<Capsule>(moving_.shape_at(parameter));
    const double together = its.radius + others.radius + distance_;
    its.radius = others.radius = 0.0;
    const Clearance axes = clearance(its, others);
    const Screw screw = moving_.screw_at(parameter);
    const Eigen::Vector3d turned = screw.turning.cross(axes.point_on_second - screw.origin);
    const PointsApart points = {axes.point_on_second - axes.point_on_first, screw.velocity + turned,
                                screw.turning.norm() * turned.norm()};
    return points.are_within(together, longest);
  }

  const Shape& fixed_;
  const Wanderer& moving_;
  double distance_;
  Interval window_;
};

}  // namespace

std::vector<Interval> colliding_parameters(const Shape& fixed, const Wanderer& moving, double distance,
                                           Interval window) {
  return Advance(fixed, moving, distance, window).run();
}

}  // namespace dualarm

#include "core/coordination/advance.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

  /// The first parameter after a collision that is seen to be free, by looking; beyond the window if none is.
  double next_free(double from) const {
    const Screw screw = moving_.screw_at(from);
    const double turning = screw.turning.norm();
    while (true) {
      // The distance to convex bodies that do not turn has no second minimum.
      const double step = turning > 0.0 ? kGap / turning : std::numeric_limits<double>::infinity();
      const double next = std::min(from + step, window_.upper);
      if (look(next, 1.0, 0.0).slack > 0.0) return next;
      if (next == window_.upper) return std::numeric_limits<double>::infinity();
      from = next;
    }
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

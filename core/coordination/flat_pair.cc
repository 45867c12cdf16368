#include "core/coordination/flat_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/plane.h"

namespace dualarm {
namespace {

/// Part of a scene's size by which a proof has to be better than rounding.
constexpr double kRounding = 1e-13;

/// A clockwise arm seen from below is a counterclockwise one.
Outline seen_with(const Base& base, const Outline& outline) { return base.sense() < 0.0 ? mirrored(outline) : outline; }

/// What a vector that turns by an angle a has along a normal, sense times: at least
/// value + lever a - bend a^2 / 2 - |lever| |a|^3 / 6, in radians.
struct Along {
  double value = 0.0;  ///< m
  double lever = 0.0;  ///< m
};

/// Lower bound, concave in the times, on what several vectors that turn together have along a normal.
struct Rotor {
  std::array<Along, 4> along;
  int count = 0;
  double bend = 0.0;   ///< m
  double lever = 0.0;  ///< m, the largest

  void add(const Eigen::Vector2d& normal, const Eigen::Vector2d& v) {
    along[count] = {normal.dot(v), normal.dot(turned_left(v))};
    bend = std::max(bend, along[count].value);
    lever = std::max(lever, std::abs(along[count].lever));
    ++count;
  }

  /// `linear` is the angle but for what accelerations add, at most `bent`; both in rad.
  double at(double linear, double bent) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) least = std::min(least, along[i].value + along[i].lever * linear);
    const double angle = std::abs(linear) + bent;
    return least - 0.5 * bend * angle * angle - lever * (bent + angle * angle * angle / 6.0);
  }
};

/// The gap along a normal that turns with one of the two bodies, or stays.
class Gap {
 public:
  /// Places are relative to the second joint.
  Gap(const Nearest& seen, const Figure& first, const Eigen::Vector2d& first_joint, const Figure& second)
      : flank_(seen.flank) {
    for (int i = 0; i < second.outline.count; ++i) second_.add(seen.normal, second.outline.corners[i]);
    for (int i = 0; i < first.outline.count; ++i) first_.add(-seen.normal, first.outline.corners[i] - first_joint);
    joint_.add(-seen.normal, first_joint);
  }

  /// Lower bound (m), concave in the times. Angles are those by which the bodies turn, as of a Rotor.
  double at(double first, double first_bent, double second, double second_bent) const {
    const double both_bent = first_bent + second_bent;
    switch (flank_) {
      case Nearest::Flank::kOfFirst:
        return second_.at(second - first, both_bent) + joint_.at(-first, first_bent) + first_.at(0.0, 0.0);
      case Nearest::Flank::kOfSecond:
        return second_.at(0.0, 0.0) + joint_.at(-second, second_bent) + first_.at(first - second, both_bent);
      case Nearest::Flank::kNone:
        break;
    }
    return second_.at(second, second_bent) + joint_.at(0.0, 0.0) + first_.at(first, first_bent);
  }

 private:
  Nearest::Flank flank_;
  Rotor second_;
  Rotor first_;
  Rotor joint_;
};

}  // namespace

FlatPair::FlatPair(const Base& first_base, const Outline& first, const Base& second_base, const Outline& second,
                   double distance)
    : first_sense_(first_base.sense() * second_base.sense()),
      first_heading_(second_base.sense() * (first_base.heading - second_base.heading)),
      second_(spinner_of(seen_with(second_base, second))),
      distance_(distance) {
  const Spinner around_its_joint = spinner_of(seen_with(second_base, first));
  first_ = around_its_joint.figure;
  first_reach_ = around_its_joint.farthest;
  joint_ = heading_of(-second_base.heading).turn((first_base.position - second_base.position).head<2>());
  joint_.y() *= second_base.sense();
}

Figure FlatPair::first_at(double theta1) const {
  return moved(first_, heading_of(first_heading_ + first_sense_ * theta1), joint_);
}

IntervalList FlatPair::slice(double theta1, double spread, Interval window) const {
  // Over the spread no point moves by more than its reach times the spread.
  return colliding_angles(first_at(theta1), second_, distance_ + first_reach_ * spread, window);
}

bool FlatPair::stays_apart(const Course& first, const Course& second, std::span<const TimePair> times) const {
  const Figure first_figure = first_at(first.position);
  const Figure second_figure = moved(second_.figure, heading_of(second.position), Eigen::Vector2d::Zero());
  const Nearest seen = nearest(first_figure, second_figure);
  if (!(seen.distance > distance_)) return false;
  const Gap gap(seen, first_figure, joint_, second_figure);
  const double needed = distance_ + kRounding * (joint_.norm() + first_reach_ + second_.farthest);
  return std::all_of(times.begin(), times.end(), [&](const TimePair& at) {
    return gap.at(first_sense_ * first.velocity * at.first, 0.5 * first.largest_acceleration * at.first * at.first,
                  second.velocity * at.second, 0.5 * second.largest_acceleration * at.second * at.second) > needed;
  });
}

}  // namespace dualarm

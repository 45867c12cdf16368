#include "core/coordination/diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/coordination/projection.h"

namespace dualarm {
namespace {

/// Part of the longer duration by which the sides of a patch may miss each other in rounding.
constexpr double kRounding = 1e-12;

/// The corners of a patch, and some points of it: their convex hull contains it.
class Corners {
 public:
  /// `last`: s, when the other arm arrives. What is infinite is cut where it stands, at 0 or `last`: everything beyond
  /// is like there.
  Corners(const Patch& patch, double last, double rounding) : patch_(patch), last_(last), rounding_(rounding) {
    add(patch.own.lower);
    add(patch.own.upper);
    for (const double other : {patch.others.lower, patch.others.upper}) {
      for (const double difference : {patch.differences.lower, patch.differences.upper}) {
        if (patch.own.contains(other + difference)) add(other + difference);
      }
    }
  }

  std::span<const TimePair> times() const { return {corners_.data(), count_}; }

  /// Counted from a moment.
  Corners since(const TimePair& moment) const {
    Corners shifted = *this;
    for (std::size_t i = 0; i < count_; ++i) {
      shifted.corners_[i] = {corners_[i].first - moment.first, corners_[i].second - moment.second};
    }
    return shifted;
  }

 private:
  /// Both ends of the other times at an own time, if there are any.
  void add(double own) {
    double lower = std::max(patch_.others.lower, own - patch_.differences.upper);
    double upper = std::min(patch_.others.upper, own - patch_.differences.lower);
    if (lower > upper + rounding_) return;
    if (std::isinf(upper)) {
      upper = last_;
      lower = std::min(lower, last_);
    }
    if (std::isinf(lower)) {
      lower = 0.0;
      upper = std::max(upper, 0.0);
    }
    corners_[count_++] = {own, lower};
    corners_[count_++] = {own, upper};
  }

  const Patch& patch_;
  double last_;
  double rounding_;
  std::array<TimePair, 12> corners_;
  std::size_t count_ = 0;
};

/// Arm 2 on its own clock.
class OtherArm final : public Meetings {
 public:
  OtherArm(const ForbiddenSet& forbidden, const Profile& first, const Profile& second)
      : forbidden_(forbidden),
        first_(first),
        second_(second),
        window_(second.extent()),
        first_acceleration_(first.largest_acceleration()),
        second_acceleration_(second.largest_acceleration()) {}

  IntervalList times_at(double position) const override { return times(position, 0.0); }
  IntervalList times_over(Interval positions) const override {
    return times(0.5 * (positions.lower + positions.upper), 0.5 * positions.length());
  }

  bool is_free(const Patch& patch) const override {
    if (!std::isfinite(first_acceleration_ + second_acceleration_)) return false;
    const double last = second_.duration();
    const Corners corners(patch, last, kRounding * (first_.duration() + last));
    if (!is_smooth_at(corners.times())) return false;
    const TimedState other = second_.passed_near(std::clamp(
        patch.time - patch.likely_difference, std::max(0.0, patch.others.lower), std::min(last, patch.others.upper)));
    const Course course = {patch.position, first_.velocity_at(*patch.leg, patch.position), first_acceleration_};
    const Course other_course = {other.state.position, other.state.velocity, second_acceleration_};
    return forbidden_.stays_apart(course, other_course, corners.since({patch.time, other.time}).times());
  }

 private:
  IntervalList times(double position, double spread) const {
    IntervalList found;
    for (const Interval& piece : forbidden_.pieces(position, spread, window_)) second_.add_times_in(piece, found);
    return found;
  }

  /// Whether arm 2 does not jump to its velocity or from it within times.
  bool is_smooth_at(std::span<const TimePair> times) const {
    const bool starts_at_rest = second_.start_state().velocity == 0.0;
    const bool ends_at_rest = second_.goal_state().velocity == 0.0;
    return std::all_of(times.begin(), times.end(), [&](const TimePair& at) {
      return (starts_at_rest || at.second >= 0.0) && (ends_at_rest || at.second <= second_.duration());
    });
  }

  const ForbiddenSet& forbidden_;
  const Profile& first_;
  const Profile& second_;
  Interval window_;             ///< rad
  double first_acceleration_;   ///< rad/s2
  double second_acceleration_;  ///< rad/s2
};

}  // namespace

bool may_meet(const ForbiddenSet& forbidden, const Profile& first, const Profile& second) {
  return !forbidden.slice_over(first.extent(), second.extent()).empty();
}

std::optional<IntervalSet> forbidden_delays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second,
                                            const Budget& budget) {
  if (!may_meet(forbidden, first, second)) return IntervalSet();
  const Profile first_clock = first.asked_often();
  const Profile second_clock = second.asked_often();
  return project(OtherArm(forbidden, first_clock, second_clock), first_clock,
                 {std::max(first.duration(), second.duration())}, budget);
}

}  // namespace dualarm

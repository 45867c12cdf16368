#include "core/coordination/forbidden_set.h"

#include <algorithm>
#include <cmath>

#include "geometry/chain.h"

namespace dualarm {
namespace {

/// The closed form is one of capsules; a request is refused that has others.
const Capsule& capsule_of(const Shape& shape) { return std::get<Capsule>(shape); }

Segment flat(const Capsule& capsule) { return {capsule.start.head<2>(), capsule.end.head<2>()}; }

/// A clockwise arm seen from below is a counterclockwise one.
Segment mirrored(const Segment& segment, const Base& base) {
  const Eigen::Vector2d mirror(1.0, base.sense());
  return {segment.start.cwiseProduct(mirror), segment.end.cwiseProduct(mirror)};
}

/// The world's segment in the frame in which the arm on `base` turns counterclockwise from the x axis.
Segment seen_from(const Base& base, const Segment& world) {
  const Eigen::Rotation2Dd back(-base.heading);
  const Eigen::Vector2d origin = base.position.head<2>();
  return mirrored({back * (world.start - origin), back * (world.end - origin)}, base);
}

/// Distance in the plane at which bodies in planes `height` apart come within `distance` of each other; negative if
/// they pass over each other.
double distance_in_plane(double distance, double height) {
  return distance < std::abs(height) ? -1.0 : std::sqrt(distance * distance - height * height);
}

}  // namespace

ForbiddenSet::ForbiddenSet(const Problem& problem, double clearance)
    : first_base_(problem.arms[0].base),
      second_base_(problem.arms[1].base),
      add_paper_set_(problem.options.region_model == RegionModel::kPaper),
      first_length_(problem.arms[0].length),
      second_length_(problem.arms[1].length) {
  for (const Body& first : moving_bodies(problem, 0)) {
    for (const Body& second : moving_bodies(problem, 1)) {
      const Capsule& a = capsule_of(first.shape);
      const Capsule& b = capsule_of(second.shape);
      const double height = first_base_.position.z() + a.start.z() - second_base_.position.z() - b.start.z();
      const double distance = distance_in_plane(a.radius + b.radius + clearance, height);
      if (distance < 0.0) continue;
      const Segment of_first = flat(a);
      pairs_.push_back(
          {of_first, mirrored(flat(b), second_base_), distance, std::max(of_first.start.norm(), of_first.end.norm())});
    }
  }
}

IntervalSet ForbiddenSet::slice(double theta1, Interval window) const { return slice(theta1, 0.0, window); }

IntervalSet ForbiddenSet::slice_over(Interval theta1, Interval window) const {
  return slice(0.5 * (theta1.lower + theta1.upper), 0.5 * theta1.length(), window);
}

bool ForbiddenSet::contains(double theta1, double theta2) const { return !slice(theta1, {theta2, theta2}).empty(); }

IntervalSet ForbiddenSet::slice(double theta1, double spread, Interval window) const {
  std::vector<Interval> forbidden;
  for (const Pair& pair : pairs_) {
    // Over the spread no point of arm 1 moves by more than its reach times the spread.
    const std::vector<Interval> angles = colliding_angles(seen_by_second(pair.of_first, theta1), pair.of_second,
                                                          pair.distance + pair.reach * spread, window);
    forbidden.insert(forbidden.end(), angles.begin(), angles.end());
  }
  if (add_paper_set_) {
    const Interval paper = paper_slice({theta1 - spread, theta1 + spread});
    forbidden.push_back({std::max(paper.lower, window.lower), std::min(paper.upper, window.upper)});
  }
  return IntervalSet(std::move(forbidden));
}

Segment ForbiddenSet::seen_by_second(const Segment& of_first, double theta1) const {
  const Eigen::Rotation2Dd turn(first_base_.heading + first_base_.sense() * theta1);
  const Eigen::Vector2d origin = first_base_.position.head<2>();
  return seen_from(second_base_, {origin + turn * of_first.start, origin + turn * of_first.end});
}

/// [paper, figure 2] R_c = { l1 cos theta1 + l2 cos theta2 >= L, theta2 <= elevation of tip 1 seen from base 2 },
/// the union over an interval of theta1. Both conditions are one-sided, so each takes its own worst case.
Interval ForbiddenSet::paper_slice(Interval theta1) const {
  const double l1 = first_length_;
  const double base_distance = (second_base_.position - first_base_.position).norm();
  const Interval range = {std::max(theta1.lower, 0.0), std::min(theta1.upper, std::numbers::pi)};
  if (range.empty()) return {1.0, 0.0};
  const double cosine = (base_distance - l1 * std::cos(range.lower)) / second_length_;
  if (cosine > 1.0) return {1.0, 0.0};
  const auto elevation = [&](double angle) {
    return std::atan2(l1 * std::sin(angle), base_distance - l1 * std::cos(angle));
  };
  const double highest = std::clamp(std::acos(std::min(1.0, l1 / base_distance)), range.lower, range.upper);
  return {0.0, std::min(std::acos(std::max(cosine, -1.0)), elevation(highest))};
}

IntervalSet blocked_positions(const Base& base, const Shape& moving, const Shape& fixed, double clearance,
                              Interval window) {
  const Capsule& a = capsule_of(moving);
  const Capsule& b = capsule_of(fixed);
  const double height = base.position.z() + a.start.z() - b.start.z();
  const double distance = distance_in_plane(a.radius + b.radius + clearance, height);
  if (distance < 0.0) return {};
  return IntervalSet(colliding_angles(seen_from(base, flat(b)), mirrored(flat(a), base), distance, window));
}

}  // namespace dualarm

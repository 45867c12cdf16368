#include "core/coordination/forbidden_set.h"

#include <algorithm>
#include <cmath>

#include "core/coordination/advance.h"
#include "geometry/chain.h"
#include "geometry/lens.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

/// A clockwise arm seen from below is a counterclockwise one.
Outline mirrored(Outline outline, const Base& base) {
  if (base.rotation == Rotation::kCounterclockwise) return outline;
  for (int i = 0; i < outline.count; ++i) outline.corners[i].y() = -outline.corners[i].y();
  std::reverse(outline.corners.begin(), outline.corners.begin() + outline.count);
  return outline;
}

/// The world's outline in the frame in which the arm on `base` turns counterclockwise from the x axis.
Outline seen_from(const Base& base, Outline world) {
  const Eigen::Matrix2d back = Eigen::Rotation2Dd(-base.heading).toRotationMatrix();
  for (int i = 0; i < world.count; ++i) world.corners[i] = back * (world.corners[i] - base.position.head<2>());
  return mirrored(world, base);
}

/// The outline of what moves with the arm on `base`, in the world.
Outline placed(Outline in_link, const Base& base, double position) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(base.heading + base.sense() * position).toRotationMatrix();
  for (int i = 0; i < in_link.count; ++i) in_link.corners[i] = turn * in_link.corners[i] + base.position.head<2>();
  return in_link;
}

double largest_radius(const Outline& outline) {
  double largest = 0.0;
  for (int i = 0; i < outline.count; ++i) largest = std::max(largest, outline.corners[i].norm());
  return largest;
}

/// What turns with a joint.
class Turning final : public Wanderer {
 public:
  Turning(const Base& base, const Shape& in_link) : base_(base), in_link_(in_link), reach_(reach(in_link)) {}

  Shape shape_at(double position) const override { return placed(in_link_, link_pose(base_, position)); }
  Screw screw_at(double /*position*/) const override {
    return {base_.position, Eigen::Vector3d::Zero(), base_.sense() * Eigen::Vector3d::UnitZ(), reach_};
  }

  /// Whether a body is out of reach of everything that turns, at a distance of at least `distance`.
  bool misses(const Shape& fixed, double distance) const {
    const double away = (centre(fixed) - base_.position).head<2>().norm();
    return away > reach_ + bounding_radius(fixed) + distance;
  }

 private:
  const Base& base_;
  const Shape& in_link_;
  double reach_;
};

std::vector<Interval> traced_angles(const Base& base, const Shape& turning, const Shape& fixed, double distance,
                                    Interval window) {
  const Turning moving(base, turning);
  if (moving.misses(fixed, distance)) return {};
  return colliding_parameters(fixed, moving, distance, window);
}

}  // namespace

ForbiddenSet::ForbiddenSet(const Problem& problem, double clearance)
    : first_base_(problem.arms[0].base),
      second_base_(problem.arms[1].base),
      clearance_(clearance),
      add_paper_set_(problem.options.region_model == RegionModel::kPaper),
      first_length_(problem.arms[0].length),
      second_length_(problem.arms[1].length) {
  const double lift = first_base_.position.z() - second_base_.position.z();
  for (const Body& first : moving_bodies(problem, 0)) {
    const auto a = upright(first.shape);
    for (const Body& second : moving_bodies(problem, 1)) {
      const auto b = upright(second.shape);
      if (!a || !b) {
        solid_pairs_.push_back({first.shape, second.shape, reach(first.shape)});
      } else if (const double distance = distance_in_plane(*a, *b, lift, clearance); distance >= 0.0) {
        flat_pairs_.push_back({a->outline, mirrored(b->outline, second_base_), distance, largest_radius(a->outline)});
      }
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
  const auto add = [&](std::vector<Interval>&& angles) {
    if (forbidden.empty()) {
      forbidden = std::move(angles);
    } else {
      forbidden.insert(forbidden.end(), angles.begin(), angles.end());
    }
  };
  // Over the spread no point of arm 1 moves by more than its reach times the spread.
  for (const FlatPair& pair : flat_pairs_) {
    const Outline first = seen_from(second_base_, placed(pair.of_first, first_base_, theta1));
    add(colliding_angles(first, pair.of_second, pair.distance + pair.reach * spread, window));
  }
  for (const SolidPair& pair : solid_pairs_) {
    const Shape first = placed(pair.of_first, link_pose(first_base_, theta1));
    add(traced_angles(second_base_, pair.of_second, first, clearance_ + pair.reach * spread, window));
  }
  if (add_paper_set_) {
    const Interval paper = paper_slice({theta1 - spread, theta1 + spread});
    forbidden.push_back({std::max(paper.lower, window.lower), std::min(paper.upper, window.upper)});
  }
  return IntervalSet(std::move(forbidden));
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
  const auto a = upright(moving);
  const auto b = upright(fixed);
  if (!a || !b) return IntervalSet(traced_angles(base, moving, fixed, clearance, window));
  const double distance = distance_in_plane(*a, *b, base.position.z(), clearance);
  if (distance < 0.0) return {};
  return IntervalSet(colliding_angles(seen_from(base, b->outline), mirrored(a->outline, base), distance, window));
}

}  // namespace dualarm

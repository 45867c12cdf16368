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
Outline seen_with(const Base& base, const Outline& outline) { return base.sense() < 0.0 ? mirrored(outline) : outline; }

/// The world's outline in the frame in which the arm on `base` turns counterclockwise from the x axis.
Outline seen_from(const Base& base, Outline world) {
  const Heading back = heading_of(-base.heading);
  for (int i = 0; i < world.count; ++i) world.corners[i] = back.turn(world.corners[i] - base.position.head<2>());
  return seen_with(base, world);
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
        flat_pairs_.emplace_back(first_base_, a->outline, second_base_, b->outline, distance);
      }
    }
  }
}

IntervalSet ForbiddenSet::slice(double theta1, Interval window) const {
  const IntervalList found = pieces(theta1, 0.0, window);
  return IntervalSet({found.begin(), found.end()});
}

IntervalSet ForbiddenSet::slice_over(Interval theta1, Interval window) const {
  const IntervalList found = pieces(0.5 * (theta1.lower + theta1.upper), 0.5 * theta1.length(), window);
  return IntervalSet({found.begin(), found.end()});
}

bool ForbiddenSet::contains(double theta1, double theta2) const { return !slice(theta1, {theta2, theta2}).empty(); }

IntervalList ForbiddenSet::pieces(double theta1, double spread, Interval window) const {
  IntervalList found;
  const auto add = [&](const auto& intervals) { found.insert(found.end(), intervals.begin(), intervals.end()); };
  for (const FlatPair& pair : flat_pairs_) add(pair.slice(theta1, spread, window));
  // Over the spread no point of arm 1 moves by more than its reach times the spread.
  for (const SolidPair& pair : solid_pairs_) {
    const Shape first = placed(pair.of_first, link_pose(first_base_, theta1));
    add(traced_angles(second_base_, pair.of_second, first, clearance_ + pair.reach * spread, window));
  }
  if (add_paper_set_) {
    const Interval paper = paper_slice({theta1 - spread, theta1 + spread});
    const Interval cut = {std::max(paper.lower, window.lower), std::min(paper.upper, window.upper)};
    if (!cut.empty()) found.push_back(cut);
  }
  return found;
}

bool ForbiddenSet::stays_apart(const Course& first, const Course& second, std::span<const TimePair> times) const {
  if (!solid_pairs_.empty() || add_paper_set_) return false;
  return std::all_of(flat_pairs_.begin(), flat_pairs_.end(),
                     [&](const FlatPair& pair) { return pair.stays_apart(first, second, times); });
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
  const IntervalList found =
      colliding_angles(seen_from(base, b->outline), seen_with(base, a->outline), distance, window);
  return IntervalSet({found.begin(), found.end()});
}

}  // namespace dualarm

#include "tests/support/independent_clearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

/// Position by the six basis polynomials of quintic Hermite interpolation. `k` moves on with the time.
double position_at(const std::vector<Knot>& knots, std::size_t& k, double time) {
  if (time >= knots.back().time) return knots.back().position;
  while (k + 2 < knots.size() && knots[k + 1].time <= time) ++k;
  const Knot& a = knots[k];
  const Knot& b = knots[k + 1];
  const double h = b.time - a.time;
  if (h <= 0.0) return b.position;
  const double u = (time - a.time) / h;
  const double w = 1.0 - u;
  const double u3 = u * u * u;
  const double w3 = w * w * w;
  return w3 * (1.0 + 3.0 * u + 6.0 * u * u) * a.position + u3 * (1.0 + 3.0 * w + 6.0 * w * w) * b.position +
         h * (u * w3 * (1.0 + 3.0 * u) * a.velocity - w * u3 * (1.0 + 3.0 * w) * b.velocity) +
         0.5 * h * h * (u * u * w3 * a.acceleration + w * w * u3 * b.acceleration);
}

struct Place {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

Place place_of(const Base& base, double position) {
  const double half = 0.5 * (base.heading + base.sense() * position);
  return {Eigen::Quaterniond(std::cos(half), 0.0, 0.0, std::sin(half)), base.position};
}

Place place_on(const PoseTrack& track, double time) {
  const std::vector<TimedPose>& poses = track.poses();
  std::size_t i = 0;
  while (i + 1 < poses.size() && poses[i + 1].time <= time) ++i;
  const Place from = {Eigen::Quaterniond(poses[i].pose.linear()), poses[i].pose.translation()};
  if (i + 1 == poses.size() || time <= poses[i].time) return from;
  const double share = (time - poses[i].time) / (poses[i + 1].time - poses[i].time);
  return {from.turn.slerp(share, Eigen::Quaterniond(poses[i + 1].pose.linear())),
          (1.0 - share) * from.origin + share * poses[i + 1].pose.translation()};
}

Shape moved(Shape shape, const Place& place) {
  const auto at = [&](const Eigen::Vector3d& point) { return Eigen::Vector3d(place.turn * point + place.origin); };
  if (auto* box = std::get_if<Box>(&shape)) {
    const Eigen::Vector3d middle = at(box->pose.translation());
    box->pose.linear() = place.turn.toRotationMatrix() * box->pose.linear();
    box->pose.translation() = middle;
  } else if (auto* capsule = std::get_if<Capsule>(&shape)) {
    *capsule = {at(capsule->start), at(capsule->end), capsule->radius};
  } else {
    auto& cylinder = std::get<Cylinder>(shape);
    cylinder = {at(cylinder.start), at(cylinder.end), cylinder.radius};
  }
  return shape;
}

/// No point of the shape is farther from the origin (m).
double farthest(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return box->pose.translation().norm() + box->half_extents.norm();
  const auto of_ends = [](const auto& kind) { return std::max(kind.start.norm(), kind.end.norm()) + kind.radius; };
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return of_ends(*capsule);
  return of_ends(std::get<Cylinder>(shape));
}

/// A body with its places at all instants.
struct Sampled {
  Body body;
  const std::vector<Place>* places = nullptr;

  const Place& place(int instant) const {
    return (*places)[places->size() > 1 ? static_cast<std::size_t>(instant) : 0];
  }
  Shape at(int instant) const { return moved(body.shape, place(instant)); }

  /// No point of the body is farther (m) from where it was at another instant.
  double moved_since(int before, int now) const {
    return (place(now).origin - place(before).origin).norm() +
           farthest(body.shape) * place(before).turn.angularDistance(place(now).turn);
  }
};

/// The instants that are looked at, s.
struct Instants {
  double begin = 0.0;
  double step = 0.0;
  int count = 0;

  double time(int instant) const { return begin + instant * step; }
};

/// Looks at one pair at every instant that could be closer than the closest so far.
void look_at(const Sampled& first, const Sampled& second, const Instants& instants, SampledApproach& closest) {
  int measured_at = 0;
  double measured = 0.0;
  for (int instant = 0; instant < instants.count; ++instant) {
    const double way = first.moved_since(measured_at, instant) + second.moved_since(measured_at, instant);
    if (instant > 0 && measured - way >= closest.distance) continue;
    measured = static_cast<double>(exact_distance(first.at(instant), second.at(instant)));
    measured_at = instant;
    if (measured < closest.distance) closest = {measured, instants.time(instant), first.body.name, second.body.name};
  }
}

std::vector<Place> places_of(const Base& base, const std::vector<Knot>& knots, const Instants& instants) {
  std::vector<Place> places;
  std::size_t knot = 0;
  for (int i = 0; i < instants.count; ++i) places.push_back(place_of(base, position_at(knots, knot, instants.time(i))));
  return places;
}

/// The arms that count against everything that moves by itself.
void look_at_movers(const Problem& problem, const Trajectory& trajectory, const std::vector<int>& arms,
                    const Instants& instants, SampledApproach& closest) {
  for (const TrackedBody& mover : tracked_bodies(problem)) {
    std::vector<Place> on_track;
    for (int i = 0; i < instants.count; ++i) on_track.push_back(place_on(*mover.track, instants.time(i)));
    for (const int arm : arms) {
      const std::vector<Place> of_arm = places_of(problem.arms[arm].base, trajectory[arm].knots, instants);
      for (const Body& body : moving_bodies(problem, arm)) {
        look_at({body, &of_arm}, {mover.body, &on_track}, instants, closest);
      }
    }
  }
}

}  // namespace

SampledApproach sampled_approach(const Problem& problem, const Trajectory& trajectory, int count) {
  const double end = trajectory[0].knots.back().time;
  const Instants instants = {0.0, end / (count - 1), count};
  const std::array<std::vector<Place>, kArmCount> of_arm = {
      places_of(problem.arms[0].base, trajectory[0].knots, instants),
      places_of(problem.arms[1].base, trajectory[1].knots, instants)};
  const std::vector<Place> still = {Place{}};
  SampledApproach closest = {std::numeric_limits<double>::infinity(), 0.0, "", ""};
  for (const Body& first : moving_bodies(problem, 0)) {
    for (const Body& second : moving_bodies(problem, 1)) {
      look_at({first, &of_arm[0]}, {second, &of_arm[1]}, instants, closest);
    }
  }
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (const Body& body : moving_bodies(problem, arm)) {
      for (const Body& fixed : fixed_bodies(problem)) look_at({body, &of_arm[arm]}, {fixed, &still}, instants, closest);
    }
  }
  look_at_movers(problem, trajectory, {0, 1}, instants, closest);

  // What comes after: arms that rest at their goals stay there while objects move.
  std::vector<int> standing;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (problem.tasks[arm].goal.velocity == 0.0) standing.push_back(arm);
  }
  double settled = end;
  for (const TrackedBody& mover : tracked_bodies(problem))
    settled = std::max(settled, mover.track->poses().back().time);
  if (settled > end) {
    look_at_movers(problem, trajectory, standing, {end, (settled - end) / (count - 1), count}, closest);
  }
  return closest;
}

}  // namespace dualarm

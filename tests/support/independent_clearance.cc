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

/// Looks at one pair at every instant that could be closer than the closest so far.
void look_at(const Sampled& first, const Sampled& second, int instants, double step, SampledApproach& closest) {
  int measured_at = 0;
  double measured = 0.0;
  for (int instant = 0; instant < instants; ++instant) {
    const double way = first.moved_since(measured_at, instant) + second.moved_since(measured_at, instant);
    if (instant > 0 && measured - way >= closest.distance) continue;
    measured = static_cast<double>(exact_distance(first.at(instant), second.at(instant)));
    measured_at = instant;
    if (measured < closest.distance) closest = {measured, instant * step, first.body.name, second.body.name};
  }
}

}  // namespace

SampledApproach sampled_approach(const Problem& problem, const Trajectory& trajectory, int instants) {
  const double step = trajectory[0].knots.back().time / (instants - 1);
  std::array<std::vector<Place>, kArmCount> of_arm;
  for (int arm = 0; arm < kArmCount; ++arm) {
    std::size_t knot = 0;
    for (int i = 0; i < instants; ++i) {
      const double position = position_at(trajectory[arm].knots, knot, i * step);
      of_arm[arm].push_back(place_of(problem.arms[arm].base, position));
    }
  }
  const std::vector<Place> still = {Place{}};
  std::vector<std::vector<Place>> of_track;
  std::vector<Sampled> others;
  for (const Body& body : fixed_bodies(problem)) others.push_back({body, &still});
  const std::vector<TrackedBody> tracked = tracked_bodies(problem);
  of_track.reserve(tracked.size());
  for (const TrackedBody& mover : tracked) {
    std::vector<Place>& places = of_track.emplace_back();
    for (int i = 0; i < instants; ++i) places.push_back(place_on(*mover.track, i * step));
    others.push_back({mover.body, &places});
  }
  SampledApproach closest = {std::numeric_limits<double>::infinity(), 0.0, "", ""};
  for (const Body& first : moving_bodies(problem, 0)) {
    for (const Body& second : moving_bodies(problem, 1)) {
      look_at({first, &of_arm[0]}, {second, &of_arm[1]}, instants, step, closest);
    }
  }
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (const Body& body : moving_bodies(problem, arm)) {
      for (const Sampled& other : others) look_at({body, &of_arm[arm]}, other, instants, step, closest);
    }
  }
  return closest;
}

}  // namespace dualarm

#include "core/verification/body_pair.h"

#include <algorithm>

#include "core/verification/separation.h"
#include "core/verification/tolerances.h"
#include "geometry/motion_bound.h"

namespace dualarm {
namespace {

CarriedBody carried(Body body, const Base& base, const Interpolant& motion) {
  const double its_reach = reach(body.shape);
  return {std::move(body), base, &motion, its_reach};
}

/// Largest way (m) of any point of the body from where it is in the middle of the interval.
double farthest_way(const CarriedBody& body, Interval time, double middle) {
  return body.reach * std::max(body.motion->travel({time.lower, middle}), body.motion->travel({middle, time.upper}));
}

TurningBody turning_body(const CarriedBody& carried_body, Interval time, double middle) {
  const JointState state = carried_body.motion->state(middle);
  const Interpolant::Bounds bounds = carried_body.motion->bounds(time);
  return {placed(std::get<Capsule>(carried_body.body.shape), link_pose(carried_body.base, state.position)),
          carried_body.base.position,
          carried_body.reach,
          carried_body.base.sense() * state.velocity,
          bounds.speed,
          bounds.acceleration};
}

}  // namespace

CarriedBodies carried_bodies(const Problem& problem, const std::array<Interpolant, kArmCount>& motions,
                             const Interpolant& rest) {
  CarriedBodies bodies;
  for (int arm = 0; arm < kArmCount; ++arm) {
    for (const Body& body : moving_bodies(problem, arm)) {
      bodies.moving[arm].push_back(carried(body, problem.arms[arm].base, motions[arm]));
    }
  }
  for (const Body& body : fixed_bodies(problem)) bodies.fixed.push_back(carried(body, Base{}, rest));
  return bodies;
}

std::vector<BodyPair> pairs_that_may_meet(const CarriedBodies& bodies) {
  std::vector<BodyPair> pairs;
  const auto pair_up = [&pairs](const std::vector<CarriedBody>& firsts, const std::vector<CarriedBody>& seconds) {
    for (const CarriedBody& first : firsts) {
      for (const CarriedBody& second : seconds) {
        pairs.push_back({&first, &second, clearance_error(first.body.shape, second.body.shape)});
      }
    }
  };
  pair_up(bodies.moving[0], bodies.moving[1]);
  pair_up(bodies.moving[0], bodies.fixed);
  pair_up(bodies.moving[1], bodies.fixed);
  return pairs;
}

double swept_distance(const BodyPair& pair) {
  const Eigen::Vector3d apart = pair.second->base.position - pair.first->base.position;
  return apart.head<2>().norm() - pair.first->reach - pair.second->reach - kSeparationRounding;
}

DistanceOverTime distance_over(const BodyPair& pair, Interval time) {
  const double middle = 0.5 * (time.lower + time.upper);
  const TurningBody first = turning_body(*pair.first, time, middle);
  const TurningBody second = turning_body(*pair.second, time, middle);
  DistanceOverTime result = {clearance(first.capsule, second.capsule), 0.0};
  result.lower_bound = result.in_the_middle.distance - pair.error - farthest_way(*pair.first, time, middle) -
                       farthest_way(*pair.second, time, middle);
  const Eigen::Vector3d across = result.in_the_middle.point_on_first - result.in_the_middle.point_on_second;
  const double length = across.norm();
  if (length > kShortestNormal) {
    result.lower_bound =
        std::max(result.lower_bound, separation_bound(first, second, across / length, 0.5 * (time.upper - time.lower)));
  }
  return result;
}

}  // namespace dualarm

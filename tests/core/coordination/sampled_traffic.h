// Collisions of arms and objects by sampling: nothing but poses, motions and clearance().
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"
#include "tests/core/coordination/random_traffic.h"

namespace dualarm {

/// Instants at which one pair of start times is looked at.
inline constexpr int kInstantsOfALook = 3000;

/// Who is to blame for a collision: one arm with an object, or both with each other.
enum class Culprit { kNone, kFirst, kSecond, kBoth };

/// Distances beyond the clearance by sampling: nothing but clearance(), poses and motions.
class Sampled {
 public:
  explicit Sampled(const TrafficScene& scene) : scene_(scene), objects_(tracked_bodies(scene.problem)) {
    for (int i = 0; i < kArmCount; ++i) bodies_[i] = moving_bodies(scene.problem, i);
  }

  /// Whether an arm at a position is closer than the clearance and `slack` (m) to a moving object at a time.
  bool meets(int arm, double position, double time, double slack) const {
    const Eigen::Isometry3d pose = link_pose(scene_.problem.arms[arm].base, position);
    for (const TrackedBody& object : objects_) {
      const Shape there = placed(object.body.shape, object.track->pose_at(time));
      for (const Body& body : bodies_[arm]) {
        if (closer(placed(body.shape, pose), there, slack)) return true;
      }
    }
    return false;
  }

  bool arms_meet(double theta1, double theta2, double slack) const {
    for (const Body& first : bodies_[0]) {
      for (const Body& second : bodies_[1]) {
        if (closer(placed(first.shape, link_pose(scene_.problem.arms[0].base, theta1)),
                   placed(second.shape, link_pose(scene_.problem.arms[1].base, theta2)), slack)) {
          return true;
        }
      }
    }
    return false;
  }

  /// What meets with these start times, at many instants until everything has come to rest.
  Culprit culprit(double start1, double start2, double slack) const {
    const double end = std::max(
        {start1 + scene_.motions[0].duration(), start2 + scene_.motions[1].duration(), scene_.end_of_tracks()});
    for (int i = 0; i <= kInstantsOfALook; ++i) {
      const double time = end * i / kInstantsOfALook;
      const double theta1 = scene_.motions[0].at(time - start1).position;
      const double theta2 = scene_.motions[1].at(time - start2).position;
      if (meets(0, theta1, time, slack)) return Culprit::kFirst;
      if (meets(1, theta2, time, slack)) return Culprit::kSecond;
      if (arms_meet(theta1, theta2, slack)) return Culprit::kBoth;
    }
    return Culprit::kNone;
  }

  /// How much nearer (m) two things may come between two instants of collides().
  double slack_between_instants(double start1, double start2) const {
    const double end = std::max(
        {start1 + scene_.motions[0].duration(), start2 + scene_.motions[1].duration(), scene_.end_of_tracks()});
    double speed = 0.0;
    for (int i = 0; i < kArmCount; ++i) {
      const Profile& motion = scene_.motions[i];
      double fastest = 0.0;
      for (int k = 0; k <= 200; ++k) {
        fastest = std::max(fastest, std::abs(motion.at(motion.duration() * k / 200.0).velocity));
      }
      for (const Body& body : bodies_[i]) speed = std::max(speed, 1.1 * reach(body.shape) * fastest);
    }
    for (const TrackedBody& object : objects_) {
      speed = std::max(speed, object.track->largest_speed({0.0, end}) +
                                  extent(object.body.shape) * object.track->largest_turning_rate({0.0, end}));
    }
    return speed * end / kInstantsOfALook;
  }

 private:
  bool closer(const Shape& first, const Shape& second, double slack) const {
    const double distance = scene_.problem.options.clearance + slack;
    if ((centre(first) - centre(second)).norm() > bounding_radius(first) + bounding_radius(second) + distance)
      return false;
    return clearance(first, second).distance < distance;
  }

  const TrafficScene& scene_;
  std::array<std::vector<Body>, kArmCount> bodies_;
  std::vector<TrackedBody> objects_;
};

}  // namespace dualarm

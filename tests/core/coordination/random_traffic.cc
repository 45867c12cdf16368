#include "tests/core/coordination/random_traffic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/phase_plane/time_optimal.h"
#include "tests/core/coordination/random_shape.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

/// Comes from outside an arm's reach, stays for a while about where the arm is on its way, and leaves.
std::vector<Eigen::Vector3d> visit(const TrafficScene& scene, Dice& dice) {
  const int i = dice.one_of(kArmCount);
  const Arm& arm = scene.problem.arms[i];
  const double position = scene.motions[i].at(dice.between(0.3, 0.7) * scene.motions[i].duration()).position;
  const double direction = arm.base.heading + arm.base.sense() * position;
  const Eigen::Vector3d outwards(std::cos(direction), std::sin(direction), dice.between(-0.05, 0.05));
  const Eigen::Vector3d across(-outwards.y(), outwards.x(), 0.0);
  std::vector<Eigen::Vector3d> way;
  for (const double along : {2.5, dice.between(0.6, 1.0), dice.between(0.6, 1.0), 2.5}) {
    way.push_back(arm.base.position + arm.length * (along * outwards + dice.between(-0.1, 0.1) * across));
  }
  return way;
}

/// Crosses the place of both arms.
std::vector<Eigen::Vector3d> crossing(const TrafficScene& scene, Dice& dice) {
  const double size = scene.problem.arms[0].length;
  const double heading = dice.between(-kPi, kPi);
  const Eigen::Vector3d way(std::cos(heading), std::sin(heading), dice.between(-0.1, 0.1));
  const Eigen::Vector3d past = scene.problem.arms[dice.one_of(kArmCount)].base.position +
                               size * Eigen::Vector3d(dice.between(-0.8, 0.8), dice.between(-0.8, 0.8), 0.0);
  return {past - 2.5 * size * way, past - dice.between(0.0, 0.5) * size * way,
          past + dice.between(0.0, 0.5) * size * way, past + 2.5 * size * way};
}

/// One to three objects, some of them turning.
std::vector<Object> random_traffic(const TrafficScene& scene, Dice& dice) {
  std::vector<Object> objects;
  constexpr ShapeKind kKinds[] = {ShapeKind::kSphere, ShapeKind::kLevelCapsule, ShapeKind::kLeaningCapsule,
                                  ShapeKind::kUprightBox, ShapeKind::kTiltedBox};
  const double longest = scene.longest();
  for (int i = dice.one_of(3); i >= 0; --i) {
    std::vector<TimedPose> poses;
    double time = dice.between(-0.5, 0.3) * longest;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const Eigen::Vector3d& place : dice.happens(0.8) ? visit(scene, dice) : crossing(scene, dice)) {
      pose.translation() = place;
      if (dice.happens(0.5)) {
        pose.linear() =
            Eigen::AngleAxisd(dice.between(-2.0, 2.0), random_direction(dice)).toRotationMatrix() * pose.linear();
      }
      poses.push_back({time, pose});
      time += dice.between(0.1, 0.7) * longest;
    }
    objects.push_back({"mover " + std::to_string(i),
                       random_shape(kKinds[dice.one_of(5)], 0.2 * scene.problem.arms[0].length, dice),
                       MovingPlacement{PoseTrack(poses)}});
  }
  return objects;
}

}  // namespace

TrafficScene::TrafficScene(Problem from)
    : problem(std::move(from)), systems{SingleJointArm(problem.arms[0]), SingleJointArm(problem.arms[1])} {
  for (int i = 0; i < kArmCount; ++i) {
    auto motion = fastest_motion(systems[i], problem.tasks[i].start.position, problem.tasks[i].goal.position);
    if (auto* fastest = std::get_if<FastestMotion>(&motion)) motions.push_back(std::move(fastest->profile));
  }
}

double TrafficScene::longest() const { return std::max(motions[0].duration(), motions[1].duration()); }

double TrafficScene::end_of_tracks() const {
  double end = 0.0;
  for (const TrackedBody& object : tracked_bodies(problem)) end = std::max(end, object.track->end_time());
  return end;
}

TrafficScene random_traffic_scene(std::uint64_t seed) {
  Dice dice(seed);
  Problem problem = random_problem(seed);
  if (dice.happens(0.4)) problem.arms[1].base.position.x() += 10.0 * problem.arms[1].length;
  TrafficScene still(problem);
  if (still.motions.size() == 2) problem.objects = random_traffic(still, dice);
  return TrafficScene(problem);
}

}  // namespace dualarm

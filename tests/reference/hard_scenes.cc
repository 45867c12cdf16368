#include "tests/reference/hard_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSamplePeriod = 0.004;  // s, of a witness
constexpr double kRoom = 0.06;           // m, that witnesses keep: more than 4 ms at these speeds take
constexpr double kNear = 1.2;            // m: an object farther from the witness all the time is in nobody's way
constexpr double kAfter = 1.5;           // s, that objects may go on after the witness has ended

/// Where both arms are, every kSamplePeriod.
using Witness = std::vector<std::array<double, kArmCount>>;

Capsule link(const Arm& arm, double position) {
  const double direction = arm.base.heading + arm.base.sense() * position;
  const Eigen::Vector3d tip(std::cos(direction), std::sin(direction), 0.0);
  return {arm.base.position, arm.base.position + arm.length * tip, arm.radius};
}

/// One arm's witness: rests at random places with random waits.
std::vector<double> random_way(Dice& dice, const Problem& problem, int arm, int rests) {
  const SingleJointArm system(problem.arms[arm]);
  std::vector<double> way;
  JointState at = problem.tasks[arm].start;
  for (int i = 0; i <= rests; ++i) {
    JointState to = problem.tasks[arm].goal;
    if (i < rests) to = {dice.between(5.0, 120.0) * kDegree, 0.0};
    if (at.velocity == 0.0) {
      way.insert(way.end(), static_cast<int>(dice.between(0.0, 1.0) * dice.one_of(2) / kSamplePeriod), at.position);
    }
    const auto motion = fastest_motion(system, at, to, Swings::kSkip);
    const auto* fastest = std::get_if<FastestMotion>(&motion);
    if (fastest == nullptr) return {};
    for (double time = 0.0; time < fastest->profile.duration(); time += kSamplePeriod) {
      way.push_back(fastest->profile.at(time).position);
    }
    at = to;
  }
  way.push_back(at.position);
  return way;
}

std::optional<Witness> random_witness(Dice& dice, const Problem& problem) {
  for (int tries = 0; tries < 400; ++tries) {
    const std::vector<double> first = random_way(dice, problem, 0, dice.one_of(3));
    const std::vector<double> second = random_way(dice, problem, 1, dice.one_of(3));
    if (first.empty() || second.empty()) continue;
    Witness witness(std::max(first.size(), second.size()));
    bool is_free = true;
    for (std::size_t i = 0; i < witness.size() && is_free; ++i) {
      witness[i] = {first[std::min(i, first.size() - 1)], second[std::min(i, second.size() - 1)]};
      is_free = exact_distance(link(problem.arms[0], witness[i][0]), link(problem.arms[1], witness[i][1])) > kRoom;
    }
    if (is_free) return witness;
  }
  return std::nullopt;
}

/// The least distance (m) of an object from both arms on their witness, and at their goals as long as it moves.
double distance_from(const Problem& problem, const Witness& witness, const Object& object) {
  const auto* moving = std::get_if<MovingPlacement>(&object.placement);
  const double last = moving != nullptr ? moving->track.end_time() : 0.0;
  const auto count = std::max(witness.size(), static_cast<std::size_t>(last / kSamplePeriod) + 2);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const double time = kSamplePeriod * static_cast<double>(i);
    const auto pose = moving != nullptr ? moving->track.pose_at(time) : std::get<FixedPlacement>(object.placement).pose;
    const Capsule body = placed(std::get<Capsule>(object.shape), pose);
    for (int arm = 0; arm < kArmCount; ++arm) {
      const double position = witness[std::min(i, witness.size() - 1)][arm];
      least = std::min(least, static_cast<double>(exact_distance(link(problem.arms[arm], position), body)));
    }
  }
  return least;
}

Eigen::Isometry3d at(const Eigen::Vector3d& place) { return Eigen::Isometry3d(Eigen::Translation3d(place)); }

/// Somewhere that an arm may sweep.
Eigen::Vector3d place_in_reach(Dice& dice, const Arm& arm) {
  const double direction = arm.base.heading + arm.base.sense() * dice.between(10.0, 110.0) * kDegree;
  return arm.base.position +
         arm.length * dice.between(0.55, 1.05) * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
}

Capsule random_body(Dice& dice) {
  const double half = dice.happens(0.5) ? 0.0 : dice.between(0.1, 0.5);
  const double bearing = dice.between(0.0, std::numbers::pi);
  const Eigen::Vector3d end = half * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0);
  return {-end, end, dice.between(0.15, 0.4)};
}

/// Crosses an arm's sweep in a straight line, or goes there, stays for a while and leaves.
Object crossing(Dice& dice, const Arm& arm, double until, const std::string& name) {
  const Eigen::Vector3d place = place_in_reach(dice, arm);
  const double bearing = dice.between(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3d way = 12.0 * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0);
  const double speed = dice.between(2.0, 8.0);
  const double there = dice.between(0.0, until);
  const double stay = dice.happens(0.5) ? 0.0 : dice.between(0.1, 1.0);
  std::vector<TimedPose> poses = {{there - 12.0 / speed, at(place - way)}, {there, at(place)}};
  if (stay > 0.0) poses.push_back({there + stay, at(place)});
  poses.push_back({there + stay + 12.0 / speed, at(place + way)});
  return {name, random_body(dice), MovingPlacement{PoseTrack(poses)}};
}

/// Balls one after the other on one line.
std::vector<Object> train(Dice& dice, const Arm& arm, double until, const std::string& name) {
  const Object first = crossing(dice, arm, 0.5 * until, name + " 1");
  const double period = dice.between(0.5, 1.2);
  std::vector<Object> balls = {first};
  for (int i = 1; i < 4; ++i) {
    std::vector<TimedPose> poses = std::get<MovingPlacement>(first.placement).track.poses();
    for (TimedPose& pose : poses) pose.time += period * i;
    balls.push_back({name + " " + std::to_string(i + 1), first.shape, MovingPlacement{PoseTrack(poses)}});
  }
  return balls;
}

Object post(Dice& dice, const Arm& arm, const std::string& name) {
  return {name, random_body(dice), FixedPlacement{at(place_in_reach(dice, arm))}};
}

/// Adds objects that leave the witness its room and are near it; as many as are wanted, if they can be found.
template <class Draw>
void place(Problem& problem, const Witness& witness, int wanted, const Draw& draw) {
  for (int tries = 0; tries < 120 && wanted > 0; ++tries) {
    const std::vector<Object> objects = draw();
    double least = std::numeric_limits<double>::infinity();
    for (const Object& object : objects) least = std::min(least, distance_from(problem, witness, object));
    if (least < kRoom || least > kNear) continue;
    problem.objects.insert(problem.objects.end(), objects.begin(), objects.end());
    --wanted;
  }
}

Problem arms_with_tasks(Dice& dice, HardKind kind) {
  const bool retreats = kind == HardKind::kBackedRetreat || kind == HardKind::kMovingRetreat;
  const auto about = [&](double degrees, double spread) { return degrees + dice.between(-spread, spread); };
  Problem problem = retreats ? paper_problem({about(10, 3), about(40, 4)}, {about(40, 4), about(10, 3)}, 0.05)
                             : paper_problem({about(25, 12), about(80, 15)}, {about(80, 15), about(25, 12)}, 0.05);
  if (!retreats && dice.happens(0.4)) std::swap(problem.tasks[1].start, problem.tasks[1].goal);
  const double inertia = dice.happens(0.5) ? 12.0 : 39.0;
  const bool starts_moving = kind == HardKind::kMovingStarts || kind == HardKind::kMovingRetreat;
  for (int i = 0; i < kArmCount; ++i) {
    Arm& arm = problem.arms[i];
    arm.inertia = inertia;
    if (kind == HardKind::kDrives) {
      arm.torque = TorqueSpeedLine{dice.between(55.0, 80.0), dice.between(2.5, 5.0)};
      arm.viscous_friction = dice.between(0.0, 4.0);
    }
    if (starts_moving) problem.tasks[i].start.velocity = -dice.between(0.0, retreats ? 0.35 : 0.8);
  }
  return problem;
}

bool ends_are_free(const Problem& problem) {
  const auto apart = [&](bool start) {
    const auto position = [&](int i) { return (start ? problem.tasks[i].start : problem.tasks[i].goal).position; };
    return exact_distance(link(problem.arms[0], position(0)), link(problem.arms[1], position(1))) > kRoom;
  };
  return apart(true) && apart(false);
}

}  // namespace

const char* name_of(HardKind kind) {
  switch (kind) {
    case HardKind::kThreeZones:
      return "three zones";
    case HardKind::kWindows:
      return "windows";
    case HardKind::kBackedRetreat:
      return "backed retreat";
    case HardKind::kMovingStarts:
      return "moving starts";
    case HardKind::kMovingRetreat:
      return "moving retreat";
    case HardKind::kDrives:
      return "drives";
  }
  return "";
}

HardScene hard_scene(HardKind kind, std::uint64_t seed) {
  Dice dice(seed * 6 + static_cast<std::uint64_t>(kind));
  for (;;) {
    Problem problem = arms_with_tasks(dice, kind);
    if (!ends_are_free(problem)) continue;
    const auto witness = random_witness(dice, problem);
    if (!witness) continue;
    const double duration = kSamplePeriod * static_cast<double>(witness->size() - 1);
    const double until = duration + kAfter;
    int number = 0;
    const auto arm = [&]() -> const Arm& { return problem.arms[number % kArmCount]; };
    const auto one = [&] { return std::vector{crossing(dice, arm(), until, "object " + std::to_string(++number))}; };
    if (kind == HardKind::kWindows) {
      place(problem, *witness, 2, [&] { return train(dice, arm(), until, "train " + std::to_string(++number)); });
    } else {
      place(problem, *witness, 4, one);
    }
    place(problem, *witness, 1, [&] { return std::vector{post(dice, arm(), "post " + std::to_string(++number))}; });
    problem.options.seed = seed;
    return {problem, duration};
  }
}

}  // namespace dualarm

#include "tests/reference/hard_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/phase_plane/time_optimal.h"
#include "core/planner.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSamplePeriod = 0.004;  // s, of a witness
constexpr double kRoom = 0.06;           // m, that witnesses keep: more than 4 ms at these speeds take
constexpr double kComesFrom = 12.0;      // m, before and after the place where it is in the way
constexpr double kPostShare = 0.2;       // of objects that stand still
constexpr int kMostObjectTries = 150;
constexpr std::size_t kMostObjects = 12;

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

/// A plan by delays and passages, if they give one.
std::optional<Plan> analytic_plan(Problem problem) {
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  Outcome outcome = plan(problem, Budget());
  if (auto* found = std::get_if<Plan>(&outcome.answer)) return std::move(*found);
  return std::nullopt;
}

/// Where an arm is in a plan at a time (s), to some millimetres.
double position_in(const Plan& plan, int arm, double time) {
  const std::vector<Knot>& knots = plan.trajectory[arm].knots;
  const auto after = std::find_if(knots.begin(), knots.end(), [time](const Knot& knot) { return knot.time >= time; });
  return after == knots.end() ? knots.back().position : after->position;
}

Capsule random_body(Dice& dice) {
  const double half = dice.happens(0.5) ? 0.0 : dice.between(0.1, 0.5);
  const double bearing = dice.between(0.0, std::numbers::pi);
  const Eigen::Vector3d end = half * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0);
  return {-end, end, dice.between(0.15, 0.4)};
}

/// On an arm of a plan at a time (s).
Eigen::Vector3d place_on(Dice& dice, const Problem& problem, const Plan& plan, int arm, double time) {
  const Capsule axis = link(problem.arms[arm], position_in(plan, arm, time));
  return axis.start + dice.between(0.6, 1.0) * (axis.end - axis.start);
}

/// Crosses an arm's way in a plan in a straight line, or goes there, stays for a while and leaves.
Object crossing(Dice& dice, const Problem& problem, const Plan& plan, const std::string& name) {
  const double there = dice.between(0.1, 0.95) * plan.duration;
  const Eigen::Vector3d place = place_on(dice, problem, plan, dice.one_of(kArmCount), there);
  const double bearing = dice.between(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3d way = kComesFrom * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0);
  const double speed = dice.between(2.0, 8.0);
  const double stay = dice.happens(0.5) ? 0.0 : dice.between(0.1, 1.0);
  std::vector<TimedPose> poses = {{there - kComesFrom / speed, at(place - way)}, {there, at(place)}};
  if (stay > 0.0) poses.push_back({there + stay, at(place)});
  poses.push_back({there + stay + kComesFrom / speed, at(place + way)});
  return {name, random_body(dice), MovingPlacement{PoseTrack(poses)}};
}

/// Balls one after the other on one line.
std::vector<Object> train(Dice& dice, const Problem& problem, const Plan& plan, const std::string& name) {
  const Object first = crossing(dice, problem, plan, name + " 1");
  const double period = dice.between(0.5, 1.2);
  std::vector<Object> balls = {first};
  for (int i = 1; i < 4; ++i) {
    std::vector<TimedPose> poses = std::get<MovingPlacement>(first.placement).track.poses();
    for (TimedPose& pose : poses) pose.time += period * i;
    balls.push_back({name + " " + std::to_string(i + 1), first.shape, MovingPlacement{PoseTrack(poses)}});
  }
  return balls;
}

Object post(Dice& dice, const Problem& problem, const Plan& plan, const std::string& name) {
  const double time = dice.between(0.1, 0.95) * plan.duration;
  return {name, random_body(dice), FixedPlacement{at(place_on(dice, problem, plan, dice.one_of(kArmCount), time))}};
}

/// Puts objects in the way of plans by delays and passages, until there are none. False where that is not possible
/// with what the witness leaves, or where there has been none before.
bool obstruct(Dice& dice, HardKind kind, Problem& problem, const Witness& witness) {
  int number = 0;
  std::optional<Plan> plan = analytic_plan(problem);
  for (int tries = 0; tries < kMostObjectTries && plan; ++tries) {
    const std::string name = "object " + std::to_string(number + 1);
    std::vector<Object> objects;
    if (kind == HardKind::kWindows) {
      objects = train(dice, problem, *plan, name);
    } else if (dice.happens(kPostShare)) {
      objects = {post(dice, problem, *plan, name)};
    } else {
      objects = {crossing(dice, problem, *plan, name)};
    }
    const bool leaves_room = std::all_of(objects.begin(), objects.end(), [&](const Object& object) {
      return distance_from(problem, witness, object) >= kRoom;
    });
    if (!leaves_room) continue;
    problem.objects.insert(problem.objects.end(), objects.begin(), objects.end());
    if (problem.objects.size() > kMostObjects) return false;
    ++number;
    plan = analytic_plan(problem);
  }
  return !plan && number > 0;
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
    if (!obstruct(dice, kind, problem, *witness)) continue;
    problem.options.seed = seed;
    return {problem, duration};
  }
}

}  // namespace dualarm

#include "tests/support/problems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

Arm random_arm(Dice& dice, const std::string& name) {
  Arm arm;
  arm.name = name;
  arm.length = dice.between(2.0, 8.0);
  arm.radius = dice.happens(0.2) ? 0.0 : dice.between(0.0, 0.2);
  const double mass = dice.between(0.5, 3.0);
  arm.inertia = dice.between(0.5, 5.0) + mass * arm.length * arm.length;
  arm.gravity = paper_gravity(mass, arm.length);
  if (dice.happens(0.3)) arm.gravity.phase = dice.between(-kPi, kPi);
  const bool is_weak = dice.happens(0.15);
  const double strength = is_weak
                              ? arm.gravity.amplitude * dice.between(0.5, 1.1)
                              : arm.gravity.amplitude * dice.between(1.2, 3.0) + arm.inertia * dice.between(0.1, 1.0);
  arm.torque = Interval{-strength * dice.between(0.85, 1.15), strength};
  arm.velocity = {-dice.between(0.5, 3.0), dice.between(0.5, 3.0)};
  if (dice.happens(0.2)) {
    arm.velocity = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  return arm;
}

/// Between 2 and 6 numbers from `least` to `most`, strictly ascending.
std::vector<double> random_grid(Dice& dice, double least, double most) {
  const int count = 2 + dice.one_of(5);
  std::vector<double> grid;
  for (int i = 0; i < count; ++i) {
    grid.push_back(least +
                   (most - least) * (i + (i == 0 || i == count - 1 ? 0.0 : dice.between(-0.4, 0.4))) / (count - 1));
  }
  return grid;
}

/// Uneven everywhere, and fading with speed in the driving quadrant.
TorqueTable random_torque_table(Dice& dice, std::vector<double> positions, std::vector<double> velocities,
                                double strength) {
  TorqueTable table = {std::move(positions), std::move(velocities), {}};
  for (std::size_t row = 0; row < table.positions.size(); ++row) {
    for (const double velocity : table.velocities) {
      const double lower = strength * dice.between(0.85, 1.3) * (1.0 - 0.15 * std::max(0.0, -velocity));
      const double upper = strength * dice.between(0.85, 1.3) * (1.0 - 0.15 * std::max(0.0, velocity));
      table.limits.push_back({-lower, upper});
    }
  }
  return table;
}

/// Both arms face each other along a random direction; mirrored, both turn the other way round.
void place(Dice& dice, Problem& problem) {
  const double distance = dice.between(0.55, 1.0) * (problem.arms[0].length + problem.arms[1].length);
  const double bearing = dice.between(-kPi, kPi);
  const bool is_mirrored = dice.happens(0.5);
  const Eigen::Vector3d origin(dice.between(-5.0, 5.0), dice.between(-5.0, 5.0), dice.between(-1.0, 1.0));
  problem.arms[0].base = {origin, bearing, is_mirrored ? Rotation::kClockwise : Rotation::kCounterclockwise};
  problem.arms[1].base = {origin + distance * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0), bearing + kPi,
                          is_mirrored ? Rotation::kCounterclockwise : Rotation::kClockwise};
}

bool keeps_clearance(const Problem& problem, std::array<double, kArmCount> positions) {
  std::array<Capsule, kArmCount> links;
  for (int i = 0; i < kArmCount; ++i) {
    const Arm& arm = problem.arms[i];
    const double direction = arm.base.heading + arm.base.sense() * positions[i];
    const Eigen::Vector3d tip =
        arm.base.position + arm.length * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
    links[i] = {arm.base.position, tip, arm.radius};
  }
  return exact_distance(links[0], links[1]) > problem.options.clearance + 1e-3;
}

void draw_tasks(Dice& dice, Problem& problem) {
  for (int tries = 0; tries < 200; ++tries) {
    std::array<double, kArmCount> start;
    std::array<double, kArmCount> goal;
    for (int i = 0; i < kArmCount; ++i) {
      const double near = dice.between(0.0, 0.25 * kPi);
      const double far = near + dice.between(0.1, 0.4 * kPi);
      const int direction = dice.one_of(10);  // rise, fall, and now and then stay
      start[i] = direction < 5 ? near : far;
      goal[i] = direction == 9 ? start[i] : near + far - start[i];
      problem.tasks[i] = {{start[i], 0.0}, {goal[i], 0.0}};
    }
    if (keeps_clearance(problem, start) && keeps_clearance(problem, goal)) return;
  }
}

}  // namespace

Problem paper_problem(std::array<double, kArmCount> start_degrees, std::array<double, kArmCount> goal_degrees,
                      double radius, double clearance) {
  Problem problem;
  for (int i = 0; i < kArmCount; ++i) {
    Arm& arm = problem.arms[i];
    arm.name = i == 0 ? "arm1" : "arm2";
    arm.length = 6.0;
    arm.radius = radius;
    arm.inertia = 39.0;
    arm.gravity = paper_gravity(1.0, 6.0);
    arm.torque = Interval{-60.0, 60.0};
    arm.velocity = {-2.0, 2.0};
    problem.tasks[i] = {{start_degrees[i] * kPi / 180.0, 0.0}, {goal_degrees[i] * kPi / 180.0, 0.0}};
  }
  problem.arms[1].base = {{8.0, 0.0, 0.0}, kPi, Rotation::kClockwise};
  problem.options.clearance = clearance;
  return problem;
}

Problem random_problem(std::uint64_t seed) {
  Dice dice(seed);
  Problem problem;
  problem.arms = {random_arm(dice, "arm1"), random_arm(dice, "arm2")};
  problem.options.clearance = dice.happens(0.3) ? 0.0 : dice.between(0.0, 0.1);
  problem.options.seed = seed;
  place(dice, problem);
  draw_tasks(dice, problem);
  return problem;
}

const char* name_of(Method method) {
  switch (method) {
    case Method::kSimultaneous:
      return "simultaneous";
    case Method::kDelay:
      return "delay";
    case Method::kPassage:
      return "passage";
    case Method::kStateTime:
      return "search";
  }
  return "";
}

const char* name_of(DriveModel model) {
  switch (model) {
    case DriveModel::kAsymmetric:
      return "Asymmetric";
    case DriveModel::kTorqueSpeedLine:
      return "TorqueSpeedLine";
    case DriveModel::kPositionTable:
      return "PositionTable";
    case DriveModel::kVelocityTable:
      return "VelocityTable";
    case DriveModel::kTable:
      return "Table";
  }
  return "";
}

TorqueLimit random_torque_limit(std::uint64_t seed, DriveModel model, double strength) {
  Dice dice(seed);
  if (model == DriveModel::kAsymmetric) {
    const double ratio = std::exp(dice.between(std::log(0.4), std::log(2.5)));
    return Interval{-strength * ratio, strength};
  }
  if (model == DriveModel::kTorqueSpeedLine) {
    const double stall = strength * dice.between(0.9, 1.5);
    return TorqueSpeedLine{stall, dice.between(1.0, 6.0)};
  }
  const bool has_positions = model != DriveModel::kVelocityTable;
  const bool has_velocities = model != DriveModel::kPositionTable;
  std::vector<double> positions = has_positions ? random_grid(dice, -0.2, 3.4) : std::vector<double>{0.0};
  std::vector<double> velocities = has_velocities ? random_grid(dice, -3.0, 3.0) : std::vector<double>{0.0};
  return random_torque_table(dice, std::move(positions), std::move(velocities), strength);
}

Problem random_problem(std::uint64_t seed, DriveModel model, bool has_friction) {
  Problem problem = random_problem(seed);
  Dice dice(seed + 0x9e3779b97f4a7c15u);  // apart from the stream of the problem itself
  for (int i = 0; i < kArmCount; ++i) {
    Arm& arm = problem.arms[i];
    const double strength = std::get<Interval>(arm.torque).upper;
    arm.torque = random_torque_limit(2 * seed + i, model, strength);
    if (has_friction) arm.viscous_friction = strength * dice.between(0.0, 0.1);
  }
  return problem;
}

Problem with_moving_ends(Problem problem, std::uint64_t seed, double fastest) {
  Dice dice(seed);
  for (int i = 0; i < kArmCount; ++i) {
    const Interval limits = problem.arms[i].velocity;
    for (JointState* state : {&problem.tasks[i].start, &problem.tasks[i].goal}) {
      const double drawn = dice.between(std::max(-fastest, limits.lower), std::min(fastest, limits.upper));
      state->velocity = dice.happens(0.25) ? 0.0 : drawn;
    }
  }
  return problem;
}

}  // namespace dualarm

#include "tests/reference/random_motions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/reference/own_equation.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Uniform numbers by our own arithmetic: the standard distributions differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937_64 engine_;
};

Interval asymmetric(Dice& dice, double low, double high) { return {-dice.between(low, high), dice.between(low, high)}; }

std::vector<double> grid(Dice& dice, double from, double to, int count) {
  std::vector<double> lines;
  for (int i = 0; i < count; ++i) lines.push_back(from + (to - from) * (i + dice.between(0.0, 0.6)) / count);
  return lines;
}

TorqueTable random_table(Dice& dice, double typical) {
  TorqueTable table;
  table.positions = grid(dice, -2.5, 4.5, dice.chance(0.2) ? 1 : 4);
  table.velocities = grid(dice, -4.0, 4.0, dice.chance(0.2) ? 1 : 5);
  for (std::size_t i = 0; i < table.positions.size() * table.velocities.size(); ++i) {
    table.limits.push_back(asymmetric(dice, 0.6 * typical, 1.4 * typical));
  }
  return table;
}

void set_drive(Arm& arm, Family family, Dice& dice, double typical) {
  const double share = family == Family::kMixed ? dice.between(0.0, 1.0) : -1.0;
  if (family == Family::kTorqueSpeed || (share >= 0.0 && share < 0.3)) {
    arm.torque = TorqueSpeedLine{typical, dice.between(1.0, 6.0)};
  } else if (family == Family::kTable || (share >= 0.3 && share < 0.6)) {
    arm.torque = random_table(dice, typical);
  } else {
    arm.torque = asymmetric(dice, 0.8 * typical, 1.2 * typical);
  }
  if (family == Family::kFriction || (family == Family::kMixed && dice.chance(0.5))) {
    arm.viscous_friction = arm.inertia * dice.between(0.01, 2.0);
  }
}

Arm random_arm(Family family, Dice& dice) {
  Arm arm;
  arm.name = name_of(family);
  arm.length = 1.0;
  arm.inertia = dice.between(0.5, 4.0);
  const bool weak = family == Family::kWeak || (family == Family::kMixed && dice.chance(0.5)) ||
                    (family != Family::kStrong && dice.chance(0.15));
  const double gravity = arm.inertia * dice.between(0.5, 2.0);
  const double typical =
      gravity * (weak ? dice.between(family == Family::kWeak ? 0.2 : 0.35, 1.2) : dice.between(1.8, 5.0));
  arm.gravity = {dice.chance(0.5) ? gravity : -gravity, dice.between(-3.0, 3.0)};
  arm.joint_range = {dice.between(-3.0, -1.0), dice.between(2.0, 4.5)};
  if (family == Family::kTightRange) arm.joint_range = {dice.between(-0.2, 0.0), dice.between(1.2, 1.5)};
  arm.velocity = {-kInfinity, kInfinity};
  if (family == Family::kFastLimits || (family == Family::kMixed && dice.chance(0.5))) {
    arm.velocity = asymmetric(dice, 0.3, 2.5);
  }
  set_drive(arm, family, dice, typical);
  return arm;
}

bool can_rest(const Arm& arm, double position) {
  const OwnEquation<double> own(arm);
  constexpr double kMargin = 1e-3;  // of a rad/s2, so that no end is held by a hair
  return own.acceleration(+1, position, 0.0) > kMargin && own.acceleration(-1, position, 0.0) < -kMargin;
}

bool can_rest_somewhere(const Arm& arm) {
  constexpr int kPlaces = 40;
  int found = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    if (can_rest(arm, arm.joint_range.lower + arm.joint_range.length() * i / kPlaces)) ++found;
  }
  constexpr int kEnough = 2;
  return found >= kEnough;
}

JointState random_end(const Arm& arm, Family family, Dice& dice) {
  const Interval range = arm.joint_range;
  const bool moves = family == Family::kBoundaryVelocities ? dice.chance(0.8)
                     : family == Family::kStrong           ? false
                     : family == Family::kMixed            ? dice.chance(0.6)
                                                           : dice.chance(0.2);
  for (int tries = 0; tries < 1000; ++tries) {
    const double position = dice.between(range.lower, range.upper);
    if (moves) {
      const Interval fastest = {std::max(-2.0, arm.velocity.lower), std::min(2.0, arm.velocity.upper)};
      return {position, dice.between(fastest.lower, fastest.upper)};
    }
    if (can_rest(arm, position)) return {position, 0.0};
  }
  return {range.lower, 0.0};
}

void write(std::ostream& out, const std::vector<double>& numbers) {
  out << "{";
  for (const double number : numbers) out << number << ", ";
  out << "}";
}

}  // namespace

std::string name_of(Family family) {
  const char* names[] = {"Strong",      "Weak",  "TightRange", "FastLimits", "BoundaryVelocities",
                         "TorqueSpeed", "Table", "Friction",   "Mixed"};
  return names[static_cast<int>(family)];
}

bool velocity_matters(const Arm& arm) {
  return arm.viscous_friction > 0.0 || !std::holds_alternative<Interval>(arm.torque);
}

MotionProblem random_motion(Family family, std::uint64_t seed) {
  Dice dice(seed * 16 + static_cast<std::uint64_t>(family) + 1);
  MotionProblem problem;
  do {
    problem.arm = random_arm(family, dice);
  } while (!can_rest_somewhere(problem.arm));
  problem.start = random_end(problem.arm, family, dice);
  problem.goal = random_end(problem.arm, family, dice);
  return problem;
}

std::ostream& operator<<(std::ostream& out, const MotionProblem& problem) {
  const Arm& arm = problem.arm;
  const auto digits = out.precision(17);
  out << arm.name << " inertia " << arm.inertia << " gravity {" << arm.gravity.amplitude << ", " << arm.gravity.phase
      << "} friction " << arm.viscous_friction << " range {" << arm.joint_range.lower << ", " << arm.joint_range.upper
      << "} velocity {" << arm.velocity.lower << ", " << arm.velocity.upper << "} torque ";
  if (const auto* constant = std::get_if<Interval>(&arm.torque)) {
    out << "{" << constant->lower << ", " << constant->upper << "}";
  } else if (const auto* line = std::get_if<TorqueSpeedLine>(&arm.torque)) {
    out << "line {" << line->stall_torque << ", " << line->no_load_speed << "}";
  } else {
    const auto& table = std::get<TorqueTable>(arm.torque);
    out << "table ";
    write(out, table.positions);
    write(out, table.velocities);
    for (const Interval& at : table.limits) out << "{" << at.lower << ", " << at.upper << "}, ";
  }
  out << " start {" << problem.start.position << ", " << problem.start.velocity << "} goal {" << problem.goal.position
      << ", " << problem.goal.velocity << "}";
  out.precision(digits);
  return out;
}

}  // namespace dualarm

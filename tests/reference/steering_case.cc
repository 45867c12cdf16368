#include "tests/reference/steering_case.h"

#include <cmath>
#include <limits>

#include "tests/reference/random_drive.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Numbers out of bytes; zeros when they are used up.
class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  int byte() {
    if (bytes_.empty()) return 0;
    const int first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  double unit() {
    const int high = byte();
    const int middle = byte();
    return (65536.0 * high + 256.0 * middle + byte()) / 16777215.0;
  }

  double between(double low, double high) { return std::lerp(low, high, unit()); }

  bool chance(double share) { return byte() < 256.0 * share; }

  /// 10^-k: from next to nothing to one.
  double tiny() { return std::pow(10.0, -15.0 * unit()); }

  /// Near one, above or below, or one.
  double about_one() {
    const int kind = byte() % 3;
    return kind == 0 ? 1.0 : kind == 1 ? 1.0 + tiny() : 1.0 / (1.0 + tiny());
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

std::vector<double> lines(Source& source, double low, double high) {
  std::vector<double> grid = {source.between(low, 0.5 * (low + high))};
  for (int i = source.byte() % 4; i > 0; --i) grid.push_back(grid.back() + source.between(0.05, 0.5 * (high - low)));
  return grid;
}

TorqueLimit drive_from(Source& source, double typical) {
  const int kind = source.byte() % 4;
  if (kind == 0) return TorqueSpeedLine{typical, source.between(0.5, 8.0)};
  if (kind == 1) {
    TorqueTable table;
    table.positions = lines(source, -3.0, 4.0);
    table.velocities = lines(source, -5.0, 5.0);
    for (std::size_t i = 0; i < table.positions.size() * table.velocities.size(); ++i) {
      table.limits.push_back({-typical * source.between(0.3, 1.5), typical * source.between(0.3, 1.5)});
    }
    return table;
  }
  return Interval{-typical * source.about_one(), typical * source.about_one()};
}

Arm arm_from(Source& source) {
  Arm arm;
  arm.name = "steered";
  arm.length = 1.0;
  arm.inertia = source.between(0.2, 5.0);
  const double gravity = source.chance(0.1) ? 0.0 : source.between(-10.0, 10.0);
  arm.gravity = {gravity, source.between(-4.0, 4.0)};
  const double typical = source.chance(0.3) ? std::abs(gravity) * source.about_one() + (gravity == 0.0 ? 1.0 : 0.0)
                                            : source.between(0.5, 30.0);
  arm.torque = drive_from(source, std::max(typical, 0.01));
  if (source.chance(0.3)) arm.viscous_friction = source.between(0.0, 4.0);
  const double lower = source.between(-4.0, 1.0);
  arm.joint_range = {lower, lower + source.between(0.01, 7.0)};
  arm.velocity = {-kInfinity, kInfinity};
  if (source.chance(0.6)) arm.velocity = {-source.between(0.05, 4.0), source.between(0.05, 4.0)};
  return arm;
}

double velocity_from(Source& source, const Arm& arm) {
  const int kind = source.byte() % 8;
  const double limit = source.chance(0.5) ? arm.velocity.upper : arm.velocity.lower;
  if (kind < 3) return 0.0;
  if (kind == 3 && std::isfinite(limit)) return limit * source.about_one();
  if (kind == 4) return source.chance(0.5) ? source.tiny() : -source.tiny();
  if (kind == 5) return source.between(-6.0, 6.0);
  return source.between(std::max(-3.0, arm.velocity.lower), std::min(3.0, arm.velocity.upper));
}

double position_from(Source& source, const Arm& arm) {
  const Interval range = arm.joint_range;
  const int kind = source.byte() % 16;
  if (kind == 0) return range.lower;
  if (kind == 1) return range.upper;
  if (kind == 2) return range.lower + range.length() * source.between(-0.3, 1.3);
  if (kind == 3) return source.chance(0.5) ? range.lower + source.tiny() : range.upper - source.tiny();
  return source.between(range.lower, range.upper);
}

}  // namespace

SteeringCase steering_case(std::span<const std::uint8_t> bytes) {
  Source source(bytes);
  SteeringCase steering;
  steering.swings = source.byte() % 50 == 1 ? Swings::kSearch : Swings::kSkip;
  const bool driven = source.byte() % 16 == 1;
  const bool near = source.byte() % 8 == 1;
  MotionProblem& problem = steering.problem;
  problem.arm = arm_from(source);
  problem.start = {position_from(source, problem.arm), velocity_from(source, problem.arm)};
  problem.goal = {position_from(source, problem.arm), velocity_from(source, problem.arm)};
  if (near) {
    problem.goal.position = problem.start.position + (source.chance(0.5) ? source.tiny() : -source.tiny());
    if (source.chance(0.5)) problem.goal.velocity = problem.start.velocity;
  }
  const bool inside = problem.start.position > problem.arm.joint_range.lower &&
                      problem.start.position < problem.arm.joint_range.upper &&
                      problem.arm.velocity.contains(problem.start.velocity);
  if (driven && inside) {
    steering.drive = 1U + static_cast<std::uint64_t>(source.byte());
    problem.goal = drive_at_random(problem.arm, problem.start, steering.drive).end;
  }
  return steering;
}

std::ostream& operator<<(std::ostream& out, const SteeringCase& steering) {
  return out << steering.problem << (steering.swings == Swings::kSearch ? " search" : " skip") << " drive "
             << steering.drive;
}

}  // namespace dualarm

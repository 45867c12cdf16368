#include <benchmark/benchmark.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/phase_plane/profile.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

// The steering function: durations and arcs, no knots. Each row beside the plainest way to integrate the time of a
// known motion, a fixed Gauss-Legendre rule over its arcs. docs/performance.md has the table.

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kTasks = 256;  // that take turns, so that no branch is learned by heart
constexpr unsigned kPoints = 15;     // of the quadrature, for each arc

/// The paper's arm, l = 6, m = 1, J = 3, and a torque of 60 N m (theory.md, section 4).
Arm paper_arm() {
  Arm arm;
  arm.name = "paper";
  arm.length = 6.0;
  arm.inertia = 39.0;
  arm.gravity = {29.43, 0.0};
  arm.torque = Interval{-60.0, 60.0};
  arm.velocity = {-kInfinity, kInfinity};
  return arm;
}

struct SteeringTask {
  JointState start;
  JointState goal;
};

std::array<SteeringTask, kTasks> tasks_with(double velocity) {
  std::mt19937_64 engine(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11U) * 0x1.0p-53);
  };
  std::array<SteeringTask, kTasks> tasks;
  for (SteeringTask& task : tasks) {
    task.start = {between(0.3, 2.8), between(-velocity, velocity)};
    task.goal = {between(0.3, 2.8), between(-velocity, velocity)};
  }
  return tasks;
}

void steer(benchmark::State& state, const Arm& arm, double velocity) {
  const SingleJointArm system(arm);
  const auto tasks = tasks_with(velocity);
  std::size_t next = 0;
  std::size_t moved = 0;
  for (auto unused : state) {
    const SteeringTask& task = tasks[next++ % kTasks];
    auto answer = fastest_motion(system, task.start, task.goal, Swings::kSkip);
    moved += std::holds_alternative<FastestMotion>(answer) ? 1 : 0;
    benchmark::DoNotOptimize(answer);
  }
  state.counters["moving"] = static_cast<double>(moved) / static_cast<double>(next);
}

/// s from an end at rest to `to`, by a fixed rule after theta = end +- u^2; the arc's torque is constant.
double arc_time(const Arm& arm, double torque, double end, double to) {
  const double sign = to < end ? -1.0 : 1.0;
  const double root = std::sqrt(std::abs(to - end));
  const auto integrand = [&](double u) {
    const double at = end + sign * u * u;
    const double work = torque * (at - end) + arm.gravity.amplitude * (std::cos(at) - std::cos(end));
    return 2.0 * u / std::sqrt(2.0 * work / arm.inertia);
  };
  return boost::math::quadrature::gauss<double, kPoints>::integrate(integrand, 0.0, root);
}

void PlainQuadratureOfTheSameMotion(benchmark::State& state) {
  const Arm arm = paper_arm();
  const auto tasks = tasks_with(0.0);
  std::size_t next = 0;
  for (auto unused : state) {
    const SteeringTask& task = tasks[next++ % kTasks];
    const double start = task.start.position;
    const double goal = task.goal.position;
    const double drive = goal > start ? 60.0 : -60.0;
    const double change = std::cos(start) - std::cos(goal);
    const double turn = (drive * (start + goal) + arm.gravity.amplitude * change) / (2.0 * drive);
    double time = arc_time(arm, drive, start, turn) + arc_time(arm, -drive, goal, turn);
    benchmark::DoNotOptimize(time);
  }
}
BENCHMARK(PlainQuadratureOfTheSameMotion);

void ConstantLimitsRestToRest(benchmark::State& state) { steer(state, paper_arm(), 0.0); }
BENCHMARK(ConstantLimitsRestToRest);

void VelocityLimitRestToRest(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.velocity = {-0.8, 0.8};
  steer(state, arm, 0.0);
}
BENCHMARK(VelocityLimitRestToRest);

void ConstantLimitsAnyStates(benchmark::State& state) { steer(state, paper_arm(), 0.8); }
BENCHMARK(ConstantLimitsAnyStates);

void VelocityLimitAnyStates(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.velocity = {-0.9, 0.9};
  steer(state, arm, 0.8);
}
BENCHMARK(VelocityLimitAnyStates);

/// The points of the rule along an arc of a known motion, where its velocity is known and its position with it.
std::vector<JointState> points_on(const Profile& profile, const Arc& arc) {
  std::vector<JointState> points;
  for (const double abscissa : boost::math::quadrature::gauss<double, kPoints>::abscissa()) {
    for (const double share : {0.5 * (1.0 + abscissa), 0.5 * (1.0 - abscissa)}) {
      const double velocity = std::lerp(arc.start.velocity, arc.end.velocity, share);
      double early = arc.start_time;
      double late = arc.end_time;
      for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (early + late);
        const bool is_before = (profile.at(middle).velocity - velocity) * (arc.end.velocity - arc.start.velocity) < 0.0;
        (is_before ? early : late) = middle;
      }
      points.push_back(profile.at(early));
    }
  }
  return points;
}

/// The time of a known motion under a torque-speed line, dt = dv / a, by the same fixed rule: what is timed are the
/// accelerations at the points.
void PlainQuadratureOfTheTorqueSpeedLine(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.torque = TorqueSpeedLine{60.0, 3.0};
  const SingleJointArm system(arm);
  struct Piece {
    double half_gain;
    Extreme extreme;
    std::vector<JointState> points;
  };
  std::vector<std::vector<Piece>> motions;
  for (const SteeringTask& task : tasks_with(0.0)) {
    const auto answer = fastest_motion(system, task.start, task.goal, Swings::kSkip);
    const Profile& profile = std::get<FastestMotion>(answer).profile;
    std::vector<Piece>& pieces = motions.emplace_back();
    for (const Arc& arc : profile.arcs()) {
      const bool is_highest = (arc.kind == ArcKind::kAccelerate) == (direction_of(arc) > 0.0);
      pieces.push_back({0.5 * (arc.end.velocity - arc.start.velocity),
                        is_highest ? Extreme::kHighest : Extreme::kLowest, points_on(profile, arc)});
    }
  }
  const auto& weights = boost::math::quadrature::gauss<double, kPoints>::weights();
  std::size_t next = 0;
  for (auto unused : state) {
    double time = 0.0;
    for (const Piece& piece : motions[next++ % kTasks]) {
      for (std::size_t i = 0; i < piece.points.size(); ++i) {
        const JointState& at = piece.points[i];
        // The first abscissa is the middle, which stands twice in the list.
        const double weight = i < 2 ? 0.5 * weights[0] : weights[i / 2];
        time += piece.half_gain * weight / system.extreme_acceleration(piece.extreme, at.position, at.velocity);
      }
    }
    benchmark::DoNotOptimize(time);
  }
}
BENCHMARK(PlainQuadratureOfTheTorqueSpeedLine);

void TorqueSpeedLineRestToRest(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.torque = TorqueSpeedLine{60.0, 3.0};
  steer(state, arm, 0.0);
}
BENCHMARK(TorqueSpeedLineRestToRest);

void TorqueSpeedLineAnyStates(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.torque = TorqueSpeedLine{60.0, 3.0};
  steer(state, arm, 0.8);
}
BENCHMARK(TorqueSpeedLineAnyStates);

void FrictionRestToRest(benchmark::State& state) {
  Arm arm = paper_arm();
  arm.viscous_friction = 10.0;
  steer(state, arm, 0.0);
}
BENCHMARK(FrictionRestToRest);

}  // namespace
}  // namespace dualarm

BENCHMARK_MAIN();

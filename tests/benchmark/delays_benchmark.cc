#include <benchmark/benchmark.h>

#include "core/coordination/diagram.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/problems.h"

// The exact start delays of two fastest motions, and one slice of the forbidden set. docs/performance.md says what it
// showed.

namespace dualarm {
namespace {

Profile fastest(const SingleJointArm& arm, const Task& task) {
  return std::get<FastestMotion>(fastest_motion(arm, task.start.position, task.goal.position)).profile;
}

void delays_of(benchmark::State& state, const Problem& problem) {
  const SingleJointArm first(problem.arms[0]);
  const SingleJointArm second(problem.arms[1]);
  const Profile first_motion = fastest(first, problem.tasks[0]);
  const Profile second_motion = fastest(second, problem.tasks[1]);
  const ForbiddenSet forbidden(problem, 1e-4);
  for (auto unused : state) {
    benchmark::DoNotOptimize(forbidden_delays(forbidden, first_motion, second_motion, Budget()));
  }
}

void Delays(benchmark::State& state) { delays_of(state, paper_problem({30, 60}, {60, 30}, 0.1)); }
BENCHMARK(Delays)->Unit(benchmark::kMicrosecond);

void DelaysOfThinArms(benchmark::State& state) { delays_of(state, paper_problem({5, 60}, {50, 10}, 1e-3)); }
BENCHMARK(DelaysOfThinArms)->Unit(benchmark::kMicrosecond);

void DelaysOfArmsFarApart(benchmark::State& state) { delays_of(state, paper_problem({100, 90}, {140, 150}, 0.1)); }
BENCHMARK(DelaysOfArmsFarApart)->Unit(benchmark::kMicrosecond);

void Slice(benchmark::State& state) {
  const ForbiddenSet forbidden(paper_problem({30, 60}, {60, 30}, 0.1), 1e-4);
  double theta1 = 0.5;
  for (auto unused : state) {
    benchmark::DoNotOptimize(forbidden.pieces(theta1, 0.0, {0.5, 1.1}));
    theta1 = theta1 < 1.0 ? theta1 + 1e-3 : 0.5;
  }
}
BENCHMARK(Slice);

}  // namespace
}  // namespace dualarm

BENCHMARK_MAIN();

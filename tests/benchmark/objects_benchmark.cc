#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/planner.h"
#include "tests/support/problems.h"

// A whole plan with verification beside more and more objects that stand somewhere: cost has to grow no faster than
// their number. docs/performance.md has the table.

namespace dualarm {
namespace {

/// Spheres, boxes and cylinders in turn on rings around the arms, the first of them of radius `nearest` (m), at a
/// height (m) above the arms.
void surround(Problem& problem, int count, double nearest, double height) {
  constexpr int kInRing = 40;
  for (int i = 0; i < count; ++i) {
    const double radius = nearest + 0.25 * (i / kInRing);
    const double angle = 2.0 * std::numbers::pi * i / kInRing;
    FixedPlacement there;
    there.pose.translation() = Eigen::Vector3d(4.0 + radius * std::cos(angle), radius * std::sin(angle), height);
    Shape shape = Capsule{{0, 0, 0}, {0, 0, 0}, 0.05};
    if (i % 3 == 1) shape = Box{Eigen::Isometry3d::Identity(), {0.05, 0.05, 0.05}};
    if (i % 3 == 2) shape = Cylinder{{0, 0, -0.05}, {0, 0, 0.05}, 0.05};
    problem.objects.push_back({"object " + std::to_string(i), shape, there});
  }
}

void plan_beside(benchmark::State& state, const Problem& problem) {
  double verification = 0.0;
  double queries = 0.0;
  for (auto unused : state) {
    const Outcome outcome = plan(problem, Budget());
    if (!std::holds_alternative<Plan>(outcome.answer)) {
      state.SkipWithError("no plan");
      return;
    }
    verification += outcome.statistics.verification_seconds;
    queries = outcome.statistics.distance_query_count;
  }
  state.counters["verify_us"] = 1e6 * verification / static_cast<double>(state.iterations());
  state.counters["queries"] = queries;
}

// The delay of plan_benchmark, which looks at the passage too.
Problem delay_problem() { return paper_problem({30, 60}, {60, 30}, 0.1); }

/// Out of both arms' reach.
void FarObjects(benchmark::State& state) {
  Problem problem = delay_problem();
  surround(problem, static_cast<int>(state.range(0)), 12.0, 0.0);
  plan_beside(state, problem);
}
BENCHMARK(FarObjects)->Arg(0)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

/// Half a metre above the plane in which the arms move: inside their reach, and never in their way.
void ObjectsAbove(benchmark::State& state) {
  Problem problem = delay_problem();
  surround(problem, static_cast<int>(state.range(0)), 0.0, 0.5);
  plan_beside(state, problem);
}
BENCHMARK(ObjectsAbove)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace dualarm

BENCHMARK_MAIN();

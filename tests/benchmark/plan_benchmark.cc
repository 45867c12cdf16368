#include <benchmark/benchmark.h>

#include <cstdlib>
#include <new>

#include "core/planner.h"
#include "tests/support/problems.h"

// A whole plan as the server asks for it, verification included, without the wire: one scene of each method, some 200
// knots an arm. docs/performance.md has the table.

namespace {

thread_local long allocation_count = 0;  // a shared count would cost more than many an allocation

void* counted(std::size_t size) {
  ++allocation_count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace dualarm {
namespace {

constexpr double kKnots = 200.0;

/// Plans with knots as close as some 200 of them for `duration` s ask.
void plan_all(benchmark::State& state, Problem problem, Method method, double duration) {
  problem.options.knot_period = duration / kKnots;
  double queries = 0.0;
  double verification = 0.0;
  double knots = 0.0;
  const long before = allocation_count;
  for (auto unused : state) {
    const Outcome outcome = plan(problem, Budget());
    const auto* found = std::get_if<Plan>(&outcome.answer);
    if (found == nullptr || found->method != method) {
      state.SkipWithError("not the plan that is meant");
      return;
    }
    queries = outcome.statistics.distance_query_count;
    verification += outcome.statistics.verification_seconds;
    knots = static_cast<double>(found->trajectory[0].knots.size());
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["allocations"] = static_cast<double>(allocation_count - before) / runs;
  state.counters["queries"] = queries;
  state.counters["verify_us"] = 1e6 * verification / runs;
  state.counters["knots"] = knots;
}

void Simultaneous(benchmark::State& state) {
  plan_all(state, paper_problem({100, 90}, {140, 150}, 0.1), Method::kSimultaneous, 1.5);
}
BENCHMARK(Simultaneous)->Unit(benchmark::kMicrosecond);

void Delay(benchmark::State& state) { plan_all(state, paper_problem({30, 60}, {60, 30}, 0.1), Method::kDelay, 1.5); }
BENCHMARK(Delay)->Unit(benchmark::kMicrosecond);

void Passage(benchmark::State& state) {
  plan_all(state, paper_problem({5, 60}, {50, 10}, 1e-3), Method::kPassage, 2.1);
}
BENCHMARK(Passage)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace dualarm

BENCHMARK_MAIN();

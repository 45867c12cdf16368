#include "tests/load/stopping.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "server/planning_functions.h"
#include "server/request/requests.h"
#include "tests/load/requests.h"

namespace dualarm {
namespace {

constexpr double kMost = 0.020;   // s
constexpr double kLongest = 1.0;  // s of planning in which the moment lies

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Plans until the caller leaves after so many seconds; what it took in all, s.
double plan_until(const PlanningFunctions& functions, const Problem& problem, double leaves_after) {
  const double begin = processor_seconds();
  const Budget budget(Budget::Clock::time_point::max(),
                      [begin, leaves_after] { return processor_seconds() - begin >= leaves_after; });
  const auto steps = functions.begin_planning(problem, budget, {});
  if (!steps->quick()) steps->search(budget);
  return processor_seconds() - begin;
}

/// The longest time that planning went on, s.
double longest_stop(const wire::PlanMotionRequest& request, int samples, std::mt19937& random) {
  const auto parsed = parse(request);
  const Problem& problem = std::get<PlanWish>(parsed).problem;
  const PlanningFunctions functions = core_functions();
  const double whole = std::min(plan_until(functions, problem, kLongest), kLongest);
  double longest = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double moment = std::uniform_real_distribution<double>(0.0, whole)(random);
    longest = std::max(longest, plan_until(functions, problem, moment) - moment);
  }
  return longest;
}

}  // namespace

int measure_stopping(int samples, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(DUALARM_SCENARIOS)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  double worst = 0.0;
  for (const std::string& name : names) {
    const double all = longest_stop(scenario_request(name), samples, random);
    const double search = longest_stop(search_request(name, 0), samples, random);
    fmt::print("{:<16} all methods {:7.3f} ms, search alone {:7.3f} ms\n", name, 1e3 * all, 1e3 * search);
    worst = std::max({worst, all, search});
  }
  fmt::print("longest {:.3f} ms, at most {:.0f} ms wanted\n", 1e3 * worst, 1e3 * kMost);
  return worst <= kMost ? 0 : 1;
}

}  // namespace dualarm

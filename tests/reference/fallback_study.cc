// How good the search in state-time space is when it is forced: `fallback_study optimal|retreat|tight|moving|stop|hard
// [count]` prints a line a scene and a summary. docs/performance.md has its tables.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "core/fallback/state_time_planner.h"
#include "core/planner.h"
#include "core/systems/single_joint_arm.h"
#include "tests/reference/hard_scenes.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

struct Run {
  double seconds = 0.0;
  int evaluations = 0;
  double duration = 0.0;  // 0: no plan
  double gap = 0.0;
  std::string why;
};

/// s, of this thread: what else runs on the machine does not count.
double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Budget::Clock::time_point processor_time() {
  return Budget::Clock::time_point(
      std::chrono::duration_cast<Budget::Clock::duration>(std::chrono::duration<double>(processor_seconds())));
}

/// Budget and seconds are of the thread's processor: those of a core that does nothing else.
Run run(Problem problem, bool is_forced, double seconds) {
  if (is_forced) problem.options.methods = {Method::kStateTime};
  const auto begin = processor_time();
  const auto limit = std::chrono::duration_cast<Budget::Clock::duration>(std::chrono::duration<double>(seconds));
  const Outcome outcome = plan(problem, Budget(begin + limit, {}, processor_time));
  Run run;
  run.seconds = std::chrono::duration<double>(processor_time() - begin).count();
  run.evaluations = outcome.statistics.fallback_evaluation_count;
  if (const auto* found = std::get_if<Plan>(&outcome.answer)) {
    run.duration = found->duration;
    run.gap = found->certificate.gap;
    const auto wrong = independent_check(problem, found->trajectory);
    run.why = wrong.empty() ? name_of(found->method) : "WRONG: " + wrong.front();
  } else if (const auto* refused = std::get_if<Infeasible>(&outcome.answer)) {
    run.why = "INFEASIBLE: " + refused->explanation;
  } else {
    run.why = std::get<Undecided>(outcome.answer).tried.back();
  }
  return run;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

void summarise(const std::string& name, int count, const std::vector<double>& ratios,
               const std::vector<double>& seconds) {
  std::printf(
      "%s: %zu of %d solved; ratio median %.4f, 95 %% %.4f, worst %.4f; seconds median %.3f, 95 %% %.3f, worst %.3f\n",
      name.c_str(), ratios.size(), count, quantile(ratios, 0.5), quantile(ratios, 0.95), quantile(ratios, 1.0),
      quantile(seconds, 0.5), quantile(seconds, 0.95), quantile(seconds, 1.0));
}

void optimal(int wanted) {
  std::vector<double> ratios, seconds;
  int count = 0;
  for (std::uint64_t seed = 0; count < wanted; ++seed) {
    const Problem problem = random_problem(seed);
    const Outcome best = plan(problem, Budget());
    const auto* found = std::get_if<Plan>(&best.answer);
    if (found == nullptr || found->certificate.claim != Claim::kOptimal || found->duration == 0.0) continue;
    ++count;
    const Run forced = run(problem, true, 1.0);
    if (forced.duration > 0.0) ratios.push_back(forced.duration / found->duration);
    seconds.push_back(forced.seconds);
    std::printf("seed %3d %-12s %.4f forced %.4f ratio %.4f %.3f s %d %s\n", static_cast<int>(seed),
                name_of(found->method), found->duration, forced.duration, forced.duration / found->duration,
                forced.seconds, forced.evaluations, forced.why.c_str());
  }
  summarise("optimal", count, ratios, seconds);
}

void retreat(bool is_tight, double known, int count) {
  Problem problem = paper_problem({10.0, 40.0}, {40.0, 10.0}, is_tight ? 0.2 : 0.0);
  if (is_tight) {
    for (Arm& arm : problem.arms) arm.inertia = 12.0;
  }
  std::vector<double> ratios, seconds;
  for (int seed = 0; seed < count; ++seed) {
    problem.options.seed = seed;
    const Run forced = run(problem, true, 1.0);
    if (forced.duration > 0.0) ratios.push_back(forced.duration / known);
    seconds.push_back(forced.seconds);
    std::printf("seed %2d %.4f %.3f s %d %s\n", seed, forced.duration, forced.seconds, forced.evaluations,
                forced.why.c_str());
  }
  summarise(is_tight ? "tight" : "retreat", count, ratios, seconds);
}

/// Arms of all drives that begin and end in motion.
void moving(int count) {
  std::vector<double> gaps, seconds;
  int undecided = 0;
  for (int seed = 0; seed < count; ++seed) {
    const Problem drawn = seed % 2 == 0
                              ? random_problem(seed)
                              : random_problem(seed, kDriveModels[seed / 2 % kDriveModels.size()], seed % 4 == 1);
    const Run forced = run(with_moving_ends(drawn, seed, 1.0), true, 2.0);
    if (forced.duration > 0.0) gaps.push_back(1.0 + forced.gap);
    if (forced.duration == 0.0 && forced.why.rfind("INFEASIBLE", 0) != 0) ++undecided;
    seconds.push_back(forced.seconds);
    std::printf("seed %3d %.4f gap %.4f %.3f s %d %s\n", seed, forced.duration, forced.gap, forced.seconds,
                forced.evaluations, forced.why.c_str());
  }
  std::printf("%d undecided\n", undecided);
  summarise("moving", count, gaps, seconds);
}

/// How much longer a search computes after it was cancelled, milliseconds: at times from 2 to 400 ms.
void stop(int each) {
  std::vector<double> late;
  for (const HardKind kind : kHardKinds) {
    const HardScene scene = hard_scene(kind, 0);
    const SingleJointArm first(loaded_arm(scene.problem, 0));
    const SingleJointArm second(loaded_arm(scene.problem, 1));
    SearchRules rules;
    rules.clearance = 1e-4;
    for (int i = 0; i < each; ++i) {
      const double seconds = 2e-3 * std::pow(200.0, i / static_cast<double>(each));
      const double end = processor_seconds() + seconds;
      const Budget budget(Budget::Clock::time_point::max(), [end] { return processor_seconds() >= end; });
      search_state_time(scene.problem, {&first, &second}, rules, budget);
      if (processor_seconds() >= end) late.push_back(1e3 * (processor_seconds() - end));
    }
  }
  std::printf("stopped %zu searches: late by, ms: median %.3f, 95 %% %.3f, worst %.3f\n", late.size(),
              quantile(late, 0.5), quantile(late, 0.95), quantile(late, 1.0));
}

void hard(int each) {
  for (const HardKind kind : kHardKinds) {
    std::vector<double> ratios, seconds;
    for (int seed = 0; seed < each; ++seed) {
      const HardScene scene = hard_scene(kind, seed);
      const Run found = run(scene.problem, false, 2.0);
      if (found.duration > 0.0) ratios.push_back(found.duration / scene.witness_duration);
      seconds.push_back(found.seconds);
      std::printf("%s %d witness %.3f found %.3f gap %.3f %.3f s %d %s\n", name_of(kind), seed, scene.witness_duration,
                  found.duration, found.gap, found.seconds, found.evaluations, found.why.c_str());
    }
    summarise(name_of(kind), each, ratios, seconds);
  }
}

}  // namespace
}  // namespace dualarm

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "retreat";
  const int count = argc > 2 ? std::atoi(argv[2]) : 20;
  if (what == "optimal") dualarm::optimal(count);
  if (what == "retreat") dualarm::retreat(false, 2.144247, count);
  if (what == "tight") dualarm::retreat(true, 1.2664, count);
  if (what == "moving") dualarm::moving(count);
  if (what == "stop") dualarm::stop(count);
  if (what == "hard") dualarm::hard(count);
  return 0;
}

// The search in state-time space beside OMPL's own planners over torques, in one run on one core:
// `fallback_benchmark [seeds] [seconds]` prints a row a scene and planner, medians over the seeds: time to the first
// plan, and durations of the best plan after a fiftieth, a fifth and all of the seconds (0.1, 1 and 5 s of 5).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/fallback/state_time_planner.h"
#include "core/systems/single_joint_arm.h"
#include "tests/benchmark/torque_planning.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kPlanningMargin = 1e-4;  // m
constexpr int kEvaluations = 100'000;     // of our own search: some 3 s

struct Scene {
  std::string name;
  Problem problem;
};

std::vector<Scene> scenes() {
  std::vector<Scene> scenes = {{"(30,60) -> (60,30)", paper_problem({30, 60}, {60, 30}, 0.05)},
                               {"retreat (10,40) -> (40,10)", paper_problem({10, 40}, {40, 10}, 0.05)},
                               {"tight retreat, I = 12, r = 0.2", paper_problem({10, 40}, {40, 10}, 0.2)},
                               {"retreat from motion", paper_problem({10, 40}, {40, 10}, 0.05)}};
  for (Arm& arm : scenes[2].problem.arms) arm.inertia = 12.0;
  scenes[3].problem.tasks[0].start.velocity = -0.15;
  scenes[3].problem.tasks[1].start.velocity = -0.2;
  return scenes;
}

/// What became of one run: when the first plan was there, and the best duration (s) at three times.
struct Record {
  double first = kNever;
  std::vector<double> best = {kNever, kNever, kNever};
};

using Search = std::function<void(const Problem&, double, const std::function<void(double, double)>&)>;

void search_ourselves(const Problem& problem, double seconds, const std::function<void(double, double)>& on_better) {
  const SingleJointArm first(loaded_arm(problem, 0));
  const SingleJointArm second(loaded_arm(problem, 1));
  const auto begin = Budget::Clock::now();
  SearchRules rules;
  rules.clearance = problem.options.clearance + kPlanningMargin;
  rules.evaluation_limit = kEvaluations;
  rules.on_incumbent = [&](const Schedule&, double duration) {
    on_better(std::chrono::duration<double>(Budget::Clock::now() - begin).count(), duration);
  };
  const auto limit = std::chrono::duration_cast<Budget::Clock::duration>(std::chrono::duration<double>(seconds));
  const SearchResult result = search_state_time(problem, {&first, &second}, rules, Budget(begin + limit));
  if (result.schedule) on_better(seconds, result.duration);
}

Record record(const Search& search, const Problem& problem, double seconds) {
  Record record;
  const std::vector<double> marks = {seconds / 50.0, seconds / 5.0, seconds};
  search(problem, seconds, [&](double at, double duration) {
    record.first = std::min(record.first, at);
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (at <= marks[i] * 1.01) record.best[i] = std::min(record.best[i], duration);
    }
  });
  return record;
}

std::string median(std::vector<double> values, const char* format) {
  std::sort(values.begin(), values.end());
  const double middle = values[values.size() / 2];
  if (!std::isfinite(middle)) return "none";
  char text[32];
  std::snprintf(text, sizeof text, format, middle);
  return text;
}

void print_row(const std::string& scene, const std::string& planner, const std::vector<Record>& records) {
  std::vector<double> first;
  std::vector<std::vector<double>> best(3);
  int solved = 0;
  for (const Record& record : records) {
    first.push_back(1e3 * record.first);
    for (std::size_t i = 0; i < best.size(); ++i) best[i].push_back(record.best[i]);
    solved += std::isfinite(record.first) ? 1 : 0;
  }
  std::printf("| %s | %s | %d of %zu | %s | %s | %s | %s |\n", scene.c_str(), planner.c_str(), solved, records.size(),
              median(first, "%.1f").c_str(), median(best[0], "%.3f").c_str(), median(best[1], "%.3f").c_str(),
              median(best[2], "%.3f").c_str());
  std::fflush(stdout);
}

void compare(int seeds, double seconds) {
  std::printf("| scene | planner | solved | first plan, ms | after %g s | after %g s | after %g s |\n", seconds / 50.0,
              seconds / 5.0, seconds);
  std::printf("|---|---|---|---|---|---|---|\n");
  for (Scene& scene : scenes()) {
    std::vector<std::pair<std::string, Search>> searches = {{"dualarm", search_ourselves}};
    for (const TorquePlanner planner : {TorquePlanner::kRrt, TorquePlanner::kKpiece, TorquePlanner::kSst}) {
      searches.emplace_back(name_of(planner), [planner](const Problem& problem, double limit, const auto& on_better) {
        plan_by_torques(problem, planner, limit, on_better);
      });
    }
    for (const auto& [name, search] : searches) {
      std::vector<Record> records;
      for (int seed = 0; seed < seeds; ++seed) {
        scene.problem.options.seed = seed;
        records.push_back(record(search, scene.problem, seconds));
      }
      print_row(scene.name, name, records);
    }
  }
}

}  // namespace
}  // namespace dualarm

int main(int argc, char** argv) {
  dualarm::compare(argc > 1 ? std::atoi(argv[1]) : 3, argc > 2 ? std::atof(argv[2]) : 5.0);
  return 0;
}

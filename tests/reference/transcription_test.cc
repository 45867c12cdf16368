#include "tests/reference/transcription.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>

#include "core/planner.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

// The planner against an optimiser that knows nothing of it (issue 4). Slow, and so not among what ctest runs by
// itself:
//   ctest --preset release -C Slow -R Transcription --verbose
// prints a line a scene: method, both durations (s), planner over optimiser, proven bound (s), optimisations that hold.

namespace dualarm {
namespace {

constexpr int kScenes = 30;
constexpr int kShards = 10;

constexpr double kSlower = 0.005;     // of the optimiser's duration: the issue's
constexpr double kBelowBound = 2e-4;  // of a bound: what the optimiser's tolerances can gain (seen: 1e-5)
constexpr double kFailed = 0.01;      // of its duration: an optimiser slower than a plan by this has not found the way

/// Where the planner is slower than that, and by how much it may be: see docs/performance.md.
const std::map<std::string, double> kExceptions = {{"seed 172", 0.012}};

std::optional<Plan> planned(const Problem& problem) {
  Outcome outcome = plan(problem, Budget());
  if (auto* found = std::get_if<Plan>(&outcome.answer)) return std::move(*found);
  return std::nullopt;
}

/// One line of the table.
void print(const std::string& name, const Plan& plan, const Transcription& other) {
  std::cout << std::fixed << std::setprecision(5) << "| " << name << " | " << name_of(plan.method) << " | "
            << plan.duration << " | ";
  if (other.best) {
    std::cout << other.best->duration << " | " << plan.duration / other.best->duration;
  } else {
    std::cout << "nothing that holds | discarded";
  }
  std::cout << " | " << plan.certificate.lower_bound << " | " << other.held << " of " << other.runs << " |"
            << std::endl;
}

/// Compares, prints, and tells whether the optimiser found a way that is worth comparing with.
bool compare(const std::string& name, const Problem& problem, const TranscriptionEffort& effort = {}) {
  SCOPED_TRACE(name);
  const std::optional<Plan> found = planned(problem);
  if (!found) {
    ADD_FAILURE() << "no plan";
    return false;
  }
  EXPECT_TRUE(found->verification.holds());
  EXPECT_THAT(independent_check(problem, found->trajectory), testing::IsEmpty());
  const Transcription other = transcribe(problem, effort);
  print(name, *found, other);
  if (!other.best) return false;
  const double ratio = found->duration / other.best->duration;
  const auto exception = kExceptions.find(name);
  EXPECT_LE(ratio, 1.0 + (exception == kExceptions.end() ? kSlower : exception->second));
  if (exception != kExceptions.end()) {
    EXPECT_GT(ratio, 1.0 + kSlower) << "no longer an exception: take it off the list";
  }
  EXPECT_GE(other.best->duration, (1.0 - kBelowBound) * found->certificate.lower_bound);
  return ratio >= 1.0 - kFailed;
}

Problem tight_retreat() {
  Problem problem = paper_problem({10.0, 40.0}, {40.0, 10.0}, 0.2);
  for (Arm& arm : problem.arms) arm.inertia = 12.0;
  return problem;
}

/// Seeds of the first random problems whose arms have to mind each other.
std::vector<int> interacting_seeds() {
  std::vector<int> seeds;
  for (int seed = 0; static_cast<int>(seeds.size()) < kScenes; ++seed) {
    const std::optional<Plan> found = planned(random_problem(seed));
    if (found && found->method != Method::kSimultaneous) seeds.push_back(seed);
  }
  return seeds;
}

TEST(TranscriptionSmoke, PlansAreAsFastAsAnOptimisersInTwoScenes) {
  TranscriptionEffort little;
  little.rounds = 1;
  little.kinds = 4;
  EXPECT_TRUE(compare("(5,60) -> (50,10)", paper_problem({5.0, 60.0}, {50.0, 10.0}), little));
  EXPECT_TRUE(compare("seed 3", random_problem(3), little));
}

class TranscriptionScenes : public testing::TestWithParam<int> {};

TEST_P(TranscriptionScenes, AreNotPlannedSlowerThanAnOptimiserFinds) {
  const std::vector<int> seeds = interacting_seeds();
  int scenes = 0;
  int failures = 0;
  for (int i = GetParam(); i < kScenes; i += kShards) {
    ++scenes;
    failures += compare("seed " + std::to_string(seeds[i]), random_problem(seeds[i])) ? 0 : 1;
  }
  EXPECT_LE(failures, scenes / 2) << "an optimiser that finds nothing proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Shard, TranscriptionScenes, testing::Range(0, kShards));

class TranscriptionPaper : public testing::TestWithParam<std::array<std::array<double, kArmCount>, 2>> {};

TEST_P(TranscriptionPaper, RowsAreWhereTheOptimiserEnds) {
  const auto [start, goal] = GetParam();
  std::ostringstream name;
  name << "(" << start[0] << "," << start[1] << ") -> (" << goal[0] << "," << goal[1] << ")";
  EXPECT_TRUE(compare(name.str(), paper_problem(start, goal)));
}

INSTANTIATE_TEST_SUITE_P(Row, TranscriptionPaper,
                         testing::Values(std::array<std::array<double, kArmCount>, 2>{{{30, 60}, {60, 30}}},
                                         std::array<std::array<double, kArmCount>, 2>{{{20, 90}, {90, 20}}},
                                         std::array<std::array<double, kArmCount>, 2>{{{20, 70}, {60, 20}}},
                                         std::array<std::array<double, kArmCount>, 2>{{{10, 80}, {60, 15}}},
                                         std::array<std::array<double, kArmCount>, 2>{{{5, 60}, {50, 10}}},
                                         std::array<std::array<double, kArmCount>, 2>{{{10, 40}, {40, 10}}}));

// Theory, section 4: the plan takes 1.2664 s and an earlier transcription found 1.2661 s.
TEST(TranscriptionTightRetreat, IsNotPlannedSlowerThanAnOptimiserFinds) {
  EXPECT_TRUE(compare("(10,40) -> (40,10), I = 12, r = 0.2", tight_retreat()));
}

}  // namespace
}  // namespace dualarm

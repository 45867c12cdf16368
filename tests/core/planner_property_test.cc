#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/planner.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr int kScenes = 2000;
constexpr int kShards = 8;

/// Seeds 0 .. 1999 in shards, so that ctest runs them side by side.
class RandomScenes : public testing::TestWithParam<int> {};

TEST_P(RandomScenes, GiveVerifiedPlansOrRefusalsWithReasons) {
  std::map<std::string, int> outcomes;
  for (int seed = GetParam(); seed < kScenes; seed += kShards) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Problem problem = random_problem(seed);
    const Outcome outcome = plan(problem, Budget());
    if (const auto* found = std::get_if<Plan>(&outcome.answer)) {
      ++outcomes["plan, method " + std::to_string(static_cast<int>(found->method))];
      EXPECT_THAT(independent_check(problem, found->trajectory), testing::IsEmpty());
      EXPECT_TRUE(found->verification.holds());
      EXPECT_GE(found->duration, found->certificate.lower_bound * (1.0 - 1e-12));
      EXPECT_GE(found->verification.min_clearance, problem.options.clearance);
    } else if (const auto* refused = std::get_if<Infeasible>(&outcome.answer)) {
      ++outcomes["infeasible, reason " + std::to_string(static_cast<int>(refused->reason))];
      EXPECT_FALSE(refused->explanation.empty());
      EXPECT_TRUE(!refused->evidence.arm.empty() || !refused->evidence.first_body.empty());
    } else {
      const auto& undecided = std::get<Undecided>(outcome.answer);
      ++outcomes["undecided"];
      EXPECT_FALSE(undecided.tried.empty());
      for (const std::string& line : undecided.tried) EXPECT_EQ(line.find("not verified"), std::string::npos) << line;
    }
  }
  for (const auto& [name, count] : outcomes) RecordProperty(name, count);
  for (const auto& [name, count] : outcomes) std::cout << name << ": " << count << "\n";
  EXPECT_GT(outcomes["plan, method 1"], 5);
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomScenes, testing::Range(0, kShards));

}  // namespace
}  // namespace dualarm

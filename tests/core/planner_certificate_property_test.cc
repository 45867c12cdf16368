#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <string>

#include "core/planner.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr int kScenes = 1000;

const char* name_of(Claim claim) {
  return claim == Claim::kOptimal ? "optimal" : claim == Claim::kOptimalMonotone ? "optimal if monotone" : "gap";
}

// Issue 4: the gap is at most 0.1 % in 90 % of the scenes and at most 1 % in 97 %, and no plan is below its bound.
TEST(Certificates, OfRandomScenesLeaveHardlyAGap) {
  int plans = 0;
  int narrow = 0;
  int small = 0;
  std::map<std::string, int> kinds;
  for (int seed = 0; seed < kScenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Problem problem = random_problem(seed);
    const Outcome outcome = plan(problem, Budget());
    const auto* found = std::get_if<Plan>(&outcome.answer);
    if (found == nullptr) continue;
    ++plans;
    const Certificate& certificate = found->certificate;
    ++kinds[std::string(name_of(found->method)) + ", " + name_of(certificate.claim)];
    EXPECT_TRUE(found->verification.holds());
    EXPECT_THAT(independent_check(problem, found->trajectory), testing::IsEmpty());
    EXPECT_GE(found->duration, certificate.lower_bound);
    EXPECT_EQ(certificate.gate.has_value(), certificate.source == LowerBoundSource::kPassage);
    // What the planning margin costs.
    EXPECT_TRUE(certificate.claim != Claim::kOptimal || certificate.gap <= 1e-3) << certificate.gap;
    narrow += certificate.gap <= 1e-3 ? 1 : 0;
    small += certificate.gap <= 1e-2 ? 1 : 0;
    if (certificate.gap > 1e-2) {
      std::cout << "seed " << seed << ": gap " << 100.0 * certificate.gap << " %, " << name_of(found->method) << ", "
                << name_of(certificate.claim) << "\n";
    }
  }
  for (const auto& [name, count] : kinds) std::cout << name << ": " << count << "\n";
  std::cout << plans << " plans, " << 100.0 * narrow / plans << " % within 0.1 %, " << 100.0 * small / plans
            << " % within 1 %\n";
  EXPECT_GT(plans, 700);
  EXPECT_GE(narrow, 0.90 * plans);
  EXPECT_GE(small, 0.97 * plans);
}

}  // namespace
}  // namespace dualarm

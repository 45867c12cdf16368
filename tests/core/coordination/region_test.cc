#include "core/coordination/region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/coordination/forbidden_set.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

std::vector<Contour> region(const Problem& problem, int resolution) {
  return forbidden_region(problem, resolution, Budget()).value();
}

bool filled(const std::vector<Contour>& contours, double theta1, double theta2) {
  bool inside = false;
  for (const Contour& contour : contours) {
    for (std::size_t i = 0, j = contour.theta1.size() - 1; i < contour.theta1.size(); j = i++) {
      if ((contour.theta2[i] > theta2) == (contour.theta2[j] > theta2)) continue;
      const double share = (theta2 - contour.theta2[i]) / (contour.theta2[j] - contour.theta2[i]);
      if (theta1 < contour.theta1[i] + share * (contour.theta1[j] - contour.theta1[i])) inside = !inside;
    }
  }
  return inside;
}

TEST(ForbiddenRegion, IsOneLensForThePapersArms) {
  EXPECT_EQ(region(paper_problem({30, 60}, {60, 30}, 0.1), 181).size(), 1U);
}

TEST(ForbiddenRegion, FilledByTheEvenOddRuleIsTheSet) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 0.2);
  const std::vector<Contour> contours = region(problem, 181);
  const ForbiddenSet forbidden(problem, problem.options.clearance);
  int wrong = 0;
  int inside = 0;
  for (double theta1 = 0.0123; theta1 < 3.1; theta1 += 0.0171) {
    for (double theta2 = 0.0123; theta2 < 3.1; theta2 += 0.0171) {
      inside += forbidden.contains(theta1, theta2) ? 1 : 0;
      wrong += filled(contours, theta1, theta2) != forbidden.contains(theta1, theta2) ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_LE(wrong, inside / 100);  // the chords between vertices cut off slivers
}

TEST(ForbiddenRegion, HasItsVerticesOnTheBoundary) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 0.2);
  const ForbiddenSet forbidden(problem, problem.options.clearance);
  for (const Contour& contour : region(problem, 91)) {
    for (std::size_t i = 0; i < contour.theta1.size(); ++i) {
      const double theta1 = contour.theta1[i];
      const double theta2 = contour.theta2[i];
      const bool on_border = theta1 == 0.0 || theta2 == 0.0;
      EXPECT_TRUE(forbidden.contains(theta1, theta2));
      const double d = 1e-8;
      const bool free_nearby = !forbidden.contains(theta1 + d, theta2) || !forbidden.contains(theta1 - d, theta2) ||
                               !forbidden.contains(theta1, theta2 + d) || !forbidden.contains(theta1, theta2 - d);
      EXPECT_TRUE(free_nearby || on_border) << theta1 << " " << theta2;
    }
  }
}

TEST(ForbiddenRegion, IsEmptyForArmsThatCannotReachEachOther) {
  Problem problem = paper_problem({30, 60}, {60, 30}, 0.1);
  problem.arms[1].base.position.x() = 13.0;
  EXPECT_TRUE(region(problem, 61).empty());
}

TEST(ForbiddenRegion, IsNothingWhereverTheBudgetEnds) {
  const Problem problem = paper_problem({30, 60}, {60, 30}, 0.1);
  int needed = 0;
  const auto counting = [&needed] { return ++needed < 0; };
  const auto forever = Budget::Clock::time_point::max();
  const auto whole = forbidden_region(problem, 31, Budget(forever, counting));
  ASSERT_TRUE(whole);
  const int vertices = static_cast<int>(whole->front().theta1.size());
  EXPECT_GE(needed, 31 + vertices);  // one poll a column and one a vertex
  for (const int polls : {0, 15, 31, 31 + vertices / 2, needed - 1}) {
    int left = polls;
    EXPECT_FALSE(forbidden_region(problem, 31, Budget(forever, [&left] { return left-- <= 0; }))) << polls;
  }
  EXPECT_FALSE(forbidden_region(problem, 31, Budget(Budget::Clock::now())));
}

}  // namespace
}  // namespace dualarm

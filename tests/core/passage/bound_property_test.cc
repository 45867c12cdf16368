#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "core/fallback/state_time_planner.h"
#include "core/passage/proof.h"
#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr int kEvaluations = 250;  // of the search: enough for rough plans
constexpr double kMargin = 1e-4;   // m

/// Scenes of strong arms whose starts and goals keep the clearance, which the lens of their arms gets in the way of.
Problem crossing_problem(int seed) {
  Problem problem = random_problem(seed);
  for (Arm& arm : problem.arms) {
    const double strong = 1.5 * std::abs(arm.gravity.amplitude) + 0.3 * arm.inertia;
    arm.torque = Interval{-strong, strong};
  }
  return problem;
}

// The search knows nothing of gates: it drives both arms from rest to rest between states that it draws.
TEST(PassageProof, IsNeverBeatenByPlansOfTheStateTimeSearch) {
  int compared = 0;
  double tightest = 1e9;
  for (int seed = 0; seed < 260; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Problem problem = crossing_problem(seed);
    const ForbiddenSet forbidden(problem, problem.options.clearance + kMargin);
    const auto& [first, second] = problem.tasks;
    if (forbidden.contains(first.start.position, second.start.position)) continue;
    if (forbidden.contains(first.goal.position, second.goal.position)) continue;
    const SceneTravellers scene(problem);
    const PassageProof proof = passage_proof(problem, problem.options.clearance, 60.0, Budget());
    const double longer = std::max(scene.travellers[0].fastest.duration(), scene.travellers[1].fastest.duration());
    if (proof.duration <= longer * (1.0 + 1e-9) || !std::isfinite(proof.duration)) continue;
    const SearchRules rules = {.clearance = problem.options.clearance + kMargin, .evaluation_limit = kEvaluations};
    const SearchResult result = search_state_time(problem, {&scene.systems[0], &scene.systems[1]}, rules, Budget());
    if (!result.schedule) continue;
    ++compared;
    EXPECT_GE(result.duration, proof.duration);
    tightest = std::min(tightest, result.duration / proof.duration - 1.0);
  }
  std::cout << compared << " plans, the closest " << 100.0 * tightest << " % above the bound\n";
  EXPECT_GE(compared, 12);
  EXPECT_LT(tightest, 0.05);
}

}  // namespace
}  // namespace dualarm

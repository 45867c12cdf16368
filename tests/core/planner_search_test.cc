#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "core/planner.h"
#include "tests/core/planner_answers.h"
#include "tests/reference/hard_scenes.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

// The search in state-time space as part of the planner: forced, and where nothing else knows a plan. A part of the
// scenes always, all of them in the slow run: ctest --preset release -C Slow -R PlannerSearchSlow

namespace dualarm {
namespace {

Problem forced(Problem problem) {
  problem.options.methods = {Method::kStateTime};
  return problem;
}

/// Durations of forced plans over the durations of plans that are proven to be optimal, of as many random problems.
std::vector<double> ratios_to_the_optimum(int count) {
  std::vector<double> ratios;
  for (std::uint64_t seed = 0; static_cast<int>(ratios.size()) < count; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = random_problem(seed);
    const Outcome best = plan(problem, Budget());
    const auto* optimum = std::get_if<Plan>(&best.answer);
    if (optimum == nullptr || optimum->certificate.claim != Claim::kOptimal || optimum->duration == 0.0) continue;
    const Plan found = must_plan(forced(problem));
    EXPECT_EQ(found.method, Method::kStateTime);
    EXPECT_NEAR(found.certificate.lower_bound, optimum->certificate.lower_bound, 1e-9);
    ratios.push_back(found.duration / optimum->duration);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

void expect_near_the_optimum(int count) {
  const std::vector<double> ratios = ratios_to_the_optimum(count);
  ASSERT_EQ(static_cast<int>(ratios.size()), count);
  EXPECT_LE(ratios[count / 2], 1.05);
  EXPECT_LE(ratios[count * 95 / 100], 1.15);
  EXPECT_GE(ratios.front(), 1.0 - 1e-9) << "no search is faster than an optimum";
}

/// Scenes of a kind that are solved, of as many; the others have to be undecided.
int solved_hard_scenes(HardKind kind, int count) {
  int solved = 0;
  for (int seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(testing::Message() << name_of(kind) << ", seed " << seed);
    const HardScene scene = hard_scene(kind, seed);
    const Outcome outcome = plan(scene.problem, Budget());
    if (const auto* found = std::get_if<Plan>(&outcome.answer)) {
      EXPECT_TRUE(found->verification.holds());
      EXPECT_THAT(independent_check(scene.problem, found->trajectory), testing::IsEmpty());
      EXPECT_GE(found->duration, found->certificate.lower_bound * (1.0 - 1e-9));
      EXPECT_LE(found->certificate.lower_bound, scene.witness_duration);
      ++solved;
    } else {
      EXPECT_TRUE(std::holds_alternative<Undecided>(outcome.answer)) << "a witness exists";
    }
  }
  return solved;
}

TEST(PlannerSearch, IsNearTheOptimumWhereThatIsKnown) { expect_near_the_optimum(30); }

// All plans that compete end so close to the bound that no change is worth a proof, and none has evaluations to spend.
TEST(PlannerSearch, EndsWhereAllThatCompetesIsAtTheBound) {
  const Problem problem = forced(random_problem(266));
  const Plan found = must_plan(problem);
  EXPECT_THAT(independent_check(problem, found.trajectory), testing::IsEmpty());
  EXPECT_LE(found.duration, found.certificate.lower_bound * (1.0 + 1e-4));
}

TEST(PlannerSearch, SolvesAHardSceneOfEachKind) {
  for (const HardKind kind : kHardKinds) {
    if (kind != HardKind::kDrives) {
      EXPECT_EQ(solved_hard_scenes(kind, 1), 1) << name_of(kind);
    }
  }
}

TEST(PlannerSearch, TellsVerifiedPlansEachFasterThanTheOneBeforeAndTheLastIsTheAnswer) {
  const Problem problem = forced(paper_problem({10, 40}, {40, 10}, 0.05));
  std::vector<double> durations;
  int evaluations = 0;
  Observer observer;
  observer.on_incumbent = [&](const Plan& incumbent) {
    EXPECT_TRUE(incumbent.verification.holds());
    durations.push_back(incumbent.duration);
  };
  observer.on_status = [&](const PlanningStatus& status) { evaluations = status.fallback_evaluation_count; };
  const Outcome watched = plan(problem, Budget(), observer);
  const Outcome unwatched = plan(problem, Budget());
  ASSERT_GE(durations.size(), 2u);
  EXPECT_TRUE(std::is_sorted(durations.rbegin(), durations.rend()));
  EXPECT_EQ(durations.back(), std::get<Plan>(watched.answer).duration);
  EXPECT_EQ(durations.back(), std::get<Plan>(unwatched.answer).duration);
  EXPECT_EQ(evaluations, watched.statistics.fallback_evaluation_count);
  EXPECT_GT(watched.statistics.fallback_node_count, 0);
}

TEST(PlannerSearch, FindsAWayBackToAStateInMotionForAnArmThatCannotStayThere) {
  Problem problem = paper_problem({20, 70}, {20, 60}, 0.05);
  for (JointState* state : {&problem.tasks[0].start, &problem.tasks[0].goal}) state->velocity = 0.3;
  for (const Problem& asked : {problem, forced(problem)}) {
    const Plan found = must_plan(asked);
    EXPECT_EQ(found.method, Method::kStateTime);
    EXPECT_GT(found.duration, 0.74) << "the other arm's";
    EXPECT_LT(found.duration, 0.9);
  }
  problem.tasks[1] = problem.tasks[0];
  problem.tasks[1].start.position = problem.tasks[1].goal.position = 1.2;
  EXPECT_EQ(must_plan(problem).duration, 0.0) << "both are where they should be";
}

/// Arm 1 starts towards the other one: the passage found takes 1.55 s, and there are motions of 1.07 s.
Problem poor_passage() {
  Problem problem = with_moving_ends(random_problem(0), 0, 1.5);
  for (Task& task : problem.tasks) task.goal.velocity = 0.0;
  return problem;
}

Plan analytic_plan(Problem problem) {
  problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  return must_plan(problem);
}

TEST(PlannerSearch, GoesOnFromAPlanFarAboveItsBound) {
  const Problem problem = poor_passage();
  const Plan analytic = analytic_plan(problem);
  ASSERT_GT(analytic.certificate.gap, 0.1);
  std::vector<Plan> told;
  Observer observer;
  observer.on_incumbent = [&](const Plan& incumbent) { told.push_back(incumbent); };
  const Outcome watched = plan(problem, Budget(), observer);
  const Plan found = must_plan(problem);
  EXPECT_EQ(found.method, Method::kStateTime);
  EXPECT_LT(found.duration, 0.75 * analytic.duration);
  EXPECT_EQ(found.duration, std::get<Plan>(watched.answer).duration);
  ASSERT_GE(told.size(), 2u);
  EXPECT_EQ(told.front().method, analytic.method);
  EXPECT_EQ(told.front().duration, analytic.duration);
  for (std::size_t i = 1; i < told.size(); ++i) EXPECT_LT(told[i].duration, told[i - 1].duration);
  EXPECT_EQ(told.back().duration, found.duration);
}

/// Something stands in the way of arm 1 until 2.5 s. The delay waits for it at the start; an arm that begins at once
/// and waits in front of it is 15 % faster, and the delay in hand must not hide that.
TEST(PlannerSearch, IsNotHeldBackByAPlanWithAWideGap) {
  Problem problem = paper_problem({20, 70}, {60, 20}, 0.1);
  const auto at = [](double x) { return Eigen::Isometry3d(Eigen::Translation3d(x, 3.4641, 0.0)); };
  problem.objects = {ball("cart", Eigen::Vector3d::Zero(), 0.3)};
  problem.objects[0].placement = MovingPlacement{PoseTrack({{0.0, at(2.0)}, {2.5, at(2.0)}, {3.0, at(-20.0)}})};
  ASSERT_GT(analytic_plan(problem).certificate.gap, 0.1);
  const Plan found = must_plan(problem);
  EXPECT_LE(found.duration, must_plan(forced(problem)).duration * (1.0 + 1e-9));
  EXPECT_LT(found.certificate.gap, 0.05);
}

TEST(PlannerSearch, LeavesAPlanAloneThatIsNearItsBoundOrThatItMayNotImprove) {
  const Problem near = paper_problem({20, 70}, {60, 20}, 0.05);
  EXPECT_EQ(plan(near, Budget()).statistics.fallback_evaluation_count, 0);
  Problem not_allowed = poor_passage();
  not_allowed.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
  EXPECT_EQ(plan(not_allowed, Budget()).statistics.fallback_evaluation_count, 0);
}

TEST(PlannerSearch, KeepsThePlanInHandWhateverBecomesOfTheSearch) {
  const Problem problem = poor_passage();
  const Observer nobody;
  const Plan analytic = analytic_plan(problem);
  PlanningRun run(problem, Budget(), nobody);
  ASSERT_FALSE(run.quick());
  const auto in_hand = run.in_hand();
  ASSERT_TRUE(in_hand);
  EXPECT_EQ(std::get<Plan>(in_hand->answer).duration, analytic.duration);
  const Outcome ended = run.search(Budget({}, [] { return true; }));
  ASSERT_TRUE(std::holds_alternative<Plan>(ended.answer)) << "The search had no time at all.";
  EXPECT_EQ(std::get<Plan>(ended.answer).duration, analytic.duration);

  const Problem unsolved = forced(problem);
  PlanningRun searching(unsolved, Budget(), nobody);
  ASSERT_FALSE(searching.quick());
  EXPECT_FALSE(searching.in_hand());
}

/// A budget whose clock goes on by 20 us each time that it is asked.
Budget counted(double seconds) {
  const auto now = std::make_shared<Budget::Clock::time_point>();
  const auto all = std::chrono::duration_cast<Budget::Clock::duration>(std::chrono::duration<double>(seconds));
  return Budget(Budget::Clock::time_point(all), {}, [now] { return *now += std::chrono::microseconds(20); });
}

TEST(PlannerSearch, LosesNoPlanToALargerBudget) {
  const std::vector<Problem> problems = {poor_passage(), forced(paper_problem({10, 40}, {40, 10}, 0.05)),
                                         forced(random_problem(1)), hard_scene(HardKind::kMovingStarts, 0).problem};
  for (std::size_t i = 0; i < problems.size(); ++i) {
    SCOPED_TRACE(i);
    bool is_found = false;
    for (double seconds = 1e-3; seconds < 2.0; seconds *= 1.5) {
      const Outcome outcome = plan(problems[i], counted(seconds));
      const bool has_plan = std::holds_alternative<Plan>(outcome.answer);
      EXPECT_TRUE(has_plan || !is_found) << "lost at " << seconds << " s";
      is_found = is_found || has_plan;
    }
    EXPECT_TRUE(is_found);
  }
}

/// The arms' own motion pays for a swing, which no steering of the search's knows.
TEST(PlannerSearch, EndsWithDelaysAndPassagesOfTheFastestMotions) {
  for (const auto& [start, goal] : {std::pair{20.0, 60.0}, {5.0, 50.0}}) {
    const Problem problem = paper_problem({start, 60}, {goal, 20}, 0.05);
    Problem few = forced(problem);
    few.options.seed = 3;
    EXPECT_LE(must_plan(few).duration, must_plan(problem).duration * (1.0 + 1e-9));
  }
}

TEST(PlannerSearch, LooksNearTheTasksInJointRangesOfManyTurns) {
  Problem problem = paper_problem({10, 40}, {40, 10}, 0.05);
  const double narrow = must_plan(forced(problem)).duration;
  for (Arm& arm : problem.arms) arm.joint_range = {-900.0, 900.0};
  problem.options.methods = {Method::kStateTime};
  const Outcome outcome = plan(problem, counted(1.0));
  ASSERT_TRUE(std::holds_alternative<Plan>(outcome.answer));
  EXPECT_LE(std::get<Plan>(outcome.answer).duration, 1.05 * narrow);
}

TEST(PlannerSearch, KeepsToTheMemoryThatTheOptionsGiveIt) {
  Problem problem = forced(paper_problem({10, 40}, {40, 10}, 0.05));
  problem.options.search_memory = 20'000;
  const Outcome outcome = plan(problem, Budget());
  EXPECT_TRUE(std::holds_alternative<Plan>(outcome.answer));
  EXPECT_LE(outcome.statistics.fallback_memory_bytes, 20'000u);
}

TEST(PlannerSearch, FindsTheOptimalDelayExactlyByItsOwn) {
  const Plan found = must_plan(forced(paper_problem({30, 60}, {60, 30}, 0.05)));
  EXPECT_EQ(found.method, Method::kStateTime);
  EXPECT_EQ(found.certificate.claim, Claim::kOptimal);
}

TEST(PlannerSearch, SaysWhatItTriedWhereItFindsNothing) {
  Problem problem = forced(paper_problem({10, 40}, {40, 10}, 0.05));
  problem.arms[0].joint_range.lower = problem.tasks[0].start.position;
  problem.tasks[1].start.velocity = -0.9;  // into the other arm, which cannot give way: it cannot be stopped in time
  const Outcome outcome = plan(problem, Budget());
  const auto* undecided = std::get_if<Undecided>(&outcome.answer);
  ASSERT_NE(undecided, nullptr);
  EXPECT_THAT(undecided->tried.back(), testing::HasSubstr("no schedule found"));
  EXPECT_GT(undecided->best_lower_bound, 0.0);
}

TEST(PlannerSearchSlow, IsNearTheOptimumOnTwoHundredScenes) { expect_near_the_optimum(200); }

TEST(PlannerSearchSlow, SolvesSeventyTwoHardScenes) {
  int solved = 0;
  for (const HardKind kind : kHardKinds) solved += solved_hard_scenes(kind, 12);
  EXPECT_GE(solved, 69);  // 95 %
}

}  // namespace
}  // namespace dualarm

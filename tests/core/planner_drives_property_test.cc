#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "core/planner.h"
#include "tests/support/dice.h"
#include "tests/support/independent_check.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr int kScenes = 1000;
constexpr int kShards = 4;
/// Every so many scenes may be searched as well: a search under friction takes seconds.
constexpr int kSearched = 21;
constexpr double kPi = std::numbers::pi;

TorqueLimit any_limit(Dice& dice, double strength) {
  if (dice.happens(0.3)) return Interval{-strength, strength};
  if (dice.happens(0.5)) return TorqueSpeedLine{strength, dice.between(1.5, 5.0)};
  TorqueTable table{{0.4, 1.1, 2.0}, {-2.0, 0.0, 1.5}, {}};
  for (int i = 0; i < 9; ++i) {
    table.limits.push_back({-strength * dice.between(0.5, 1.0), strength * dice.between(0.5, 1.0)});
  }
  return table;
}

/// Any drive, friction, weak arms with room to swing, ends in motion, balls that stand in the way.
Problem any_problem(std::uint64_t seed) {
  Problem problem = random_problem(seed);
  Dice dice(seed);
  for (int i = 0; i < kArmCount; ++i) {
    Arm& arm = problem.arms[i];
    const double strength = torque_bounds(arm.torque).upper * (dice.happens(0.2) ? dice.between(0.3, 1.0) : 1.0);
    arm.torque = any_limit(dice, strength);
    if (dice.happens(0.4)) arm.viscous_friction = dice.between(0.0, 0.2) * arm.inertia;
    if (dice.happens(0.3)) arm.joint_range = {-dice.between(0.0, 2.0 * kPi), dice.between(1.0, 2.0) * kPi};
    if (dice.happens(0.3)) problem.tasks[i].start.velocity = dice.between(-0.7, 0.7);
    if (dice.happens(0.2)) problem.tasks[i].goal.velocity = dice.between(-0.7, 0.7);
  }
  for (int count = dice.happens(0.3) ? 2 : 0; count > 0; --count) {
    FixedPlacement placement;
    placement.pose.translation() =
        problem.arms[0].base.position + Eigen::Vector3d(dice.between(-9.0, 9.0), dice.between(-9.0, 9.0), 0.0);
    problem.objects.push_back({"ball" + std::to_string(count), Capsule{{0, 0, 0}, {0, 0, 0}, 0.15}, placement});
  }
  return problem;
}

class AnyDrives : public testing::TestWithParam<int> {};

TEST_P(AnyDrives, GiveVerifiedPlansOrRefusalsWithReasons) {
  std::map<std::string, int> outcomes;
  for (int seed = GetParam(); seed < kScenes; seed += kShards) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Problem problem = any_problem(seed);
    if (seed % kSearched != 0) problem.options.methods = {Method::kSimultaneous, Method::kDelay, Method::kPassage};
    const Outcome outcome = plan(problem, Budget());
    if (const auto* found = std::get_if<Plan>(&outcome.answer)) {
      ++outcomes["plan, method " + std::to_string(static_cast<int>(found->method)) + ", claim " +
                 std::to_string(static_cast<int>(found->certificate.claim))];
      EXPECT_THAT(independent_check(problem, found->trajectory), testing::IsEmpty());
      EXPECT_TRUE(found->verification.holds());
      EXPECT_GE(found->duration, found->certificate.lower_bound * (1.0 - 1e-12));
    } else if (const auto* refused = std::get_if<Infeasible>(&outcome.answer)) {
      ++outcomes["infeasible, reason " + std::to_string(static_cast<int>(refused->reason))];
      EXPECT_FALSE(refused->explanation.empty());
      EXPECT_TRUE(!refused->evidence.arm.empty() || !refused->evidence.first_body.empty());
    } else {
      ++outcomes["undecided"];
      const auto& undecided = std::get<Undecided>(outcome.answer);
      EXPECT_FALSE(undecided.tried.empty());
      for (const std::string& line : undecided.tried) EXPECT_EQ(line.find("not verified"), std::string::npos) << line;
    }
  }
  for (const auto& [name, count] : outcomes) RecordProperty(name, count);
  for (const auto& [name, count] : outcomes) std::cout << name << ": " << count << "\n";
}

INSTANTIATE_TEST_SUITE_P(Shard, AnyDrives, testing::Range(0, kShards));

}  // namespace
}  // namespace dualarm

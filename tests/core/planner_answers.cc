#include "tests/core/planner_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/planner.h"
#include "tests/support/independent_check.h"

namespace dualarm {

Plan must_plan(const Problem& problem) {
  Outcome outcome = plan(problem, Budget());
  const auto* found = std::get_if<Plan>(&outcome.answer);
  if (found == nullptr) {
    if (const auto* refused = std::get_if<Infeasible>(&outcome.answer)) {
      ADD_FAILURE() << "no plan: " << refused->explanation;
    } else {
      ADD_FAILURE() << "no plan: " << testing::PrintToString(std::get<Undecided>(outcome.answer).tried);
    }
    return {};
  }
  EXPECT_TRUE(found->verification.holds());
  EXPECT_THAT(independent_check(problem, found->trajectory), testing::IsEmpty());
  return *found;
}

Infeasible must_refuse(const Problem& problem) {
  Outcome outcome = plan(problem, Budget());
  const auto* refused = std::get_if<Infeasible>(&outcome.answer);
  if (refused == nullptr) {
    ADD_FAILURE() << "not refused";
    return {};
  }
  EXPECT_FALSE(refused->explanation.empty());
  return *refused;
}

Object ball(const std::string& name, const Eigen::Vector3d& at, double radius) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = at;
  return {name, Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), radius}, FixedPlacement{pose}};
}

}  // namespace dualarm

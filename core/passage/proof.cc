#include "core/passage/proof.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "core/passage/relaxed_arm.h"
#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

/// Part by which a bound is lowered for what roots and quadratures leave.
constexpr double kRounding = 1e-10;

}  // namespace

double fastest_proof(const Problem& problem, int arm, double longest) {
  const Task& task = problem.tasks[arm];
  const auto relaxed = relaxed_arm(loaded_arm(problem, arm), task, longest);
  if (!relaxed) return 0.0;
  const SingleJointArm system(*relaxed);
  const auto motion = fastest_motion(system, task.start, task.goal, Swings::kSkip);
  const auto* found = std::get_if<FastestMotion>(&motion);
  if (found == nullptr) return 0.0;
  return std::min({found->profile.duration(), complete_until(*relaxed), longest}) * (1.0 - kRounding);
}

PassageProof proof_of(const PassageBound& bound, const Problem& problem) {
  if (std::isinf(bound.duration)) return {bound.duration, std::nullopt};
  if (bound.ways.empty()) return {};
  double complete = bound.duration;
  for (int i = 0; i < kArmCount; ++i) {
    Arm arm = loaded_arm(problem, i);
    if (complete_until(arm) >= bound.duration) continue;  // in a part of the range it is later still
    arm.joint_range = reachable(arm, problem.tasks[i], bound.duration);
    complete = std::min(complete, complete_until(arm));
  }
  if (complete == 0.0) return {};
  return {complete * (1.0 - kRounding), bound.ways.front().gate};
}

PassageProof passage_proof(const Problem& problem, double clearance, double longest, const Budget& budget,
                           const std::vector<Way>& near_by) {
  std::vector<Arm> arms;
  for (int i = 0; i < kArmCount; ++i) {
    const auto relaxed = relaxed_arm(loaded_arm(problem, i), problem.tasks[i], longest);
    if (!relaxed) return {};
    arms.push_back(*relaxed);
  }
  const SingleJointArm systems[] = {SingleJointArm(arms[0]), SingleJointArm(arms[1])};
  std::vector<Profile> fastest;
  for (int i = 0; i < kArmCount; ++i) {
    const auto motion = fastest_motion(systems[i], problem.tasks[i].start, problem.tasks[i].goal, Swings::kSkip);
    if (std::holds_alternative<Blocked>(motion)) return {};
    const Profile& profile = std::get<FastestMotion>(motion).profile;
    fastest.push_back(near_by.empty() ? profile.asked_often() : profile);
  }
  const auto traveller = [&](int i) {
    return Traveller{&systems[i], problem.tasks[i].start, problem.tasks[i].goal, fastest[i]};
  };
  Problem reached = problem;
  for (int i = 0; i < kArmCount; ++i) reached.arms[i].joint_range = arms[i].joint_range;
  const PassageBound bound =
      passage_bound(ForbiddenPlane(reached, clearance), Travellers{traveller(0), traveller(1)}, budget, near_by);
  if (bound.ways.empty() && !std::isinf(bound.duration)) return {};
  const double proven = std::min({bound.duration, longest, complete_until(arms[0]), complete_until(arms[1])});
  return {proven * (1.0 - kRounding), bound.ways.empty() ? std::nullopt : std::optional(bound.ways.front().gate)};
}

}  // namespace dualarm

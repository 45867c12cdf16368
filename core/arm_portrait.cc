#include "core/arm_portrait.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/phase_plane/time_optimal.h"
#include "core/refuse_blocked.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {
namespace {

Claim claim_of(MinimumOver minimum_over) {
  switch (minimum_over) {
    case MinimumOver::kAllMotions:
      return Claim::kOptimal;
    case MinimumOver::kMonotoneMotions:
      return Claim::kOptimalMonotone;
    case MinimumOver::kSearchedMotions:
      return Claim::kGap;
  }
  throw std::logic_error("a MinimumOver without a claim");
}

DrawnMotion drawn(const FastestMotion& motion, int resolution) {
  const Profile& profile = motion.profile;
  DrawnMotion drawn = {profile.duration(),     motion.lower_bound, claim_of(motion.minimum_over), profile.arcs(), {0.0},
                       {profile.start_state()}};
  for (const Arc& arc : profile.arcs()) {
    const double share = (arc.end_time - arc.start_time) / profile.duration();
    const int count = std::max(1, static_cast<int>(std::lround(share * (resolution - 1))));
    const std::vector<JointState> states = profile.states_along(arc, count);
    for (int k = 1; k <= count; ++k) {
      drawn.times.push_back(std::lerp(arc.start_time, arc.end_time, static_cast<double>(k) / count));
      drawn.states.push_back(states[k]);
    }
  }
  return drawn;
}

Undecided not_found(const Infeasible& refusal, const Blocked& blocked) {
  return {"No motion was found and none is excluded: " + refusal.explanation,
          {blocked.is_searched_out ? "fastest motion: one way and with swings to and fro"
                                   : "fastest motion: one way, and with swings to and fro until time ran out"},
          0.0,
          blocked.lower_bound};
}

}  // namespace

std::optional<ArmPortrait> arm_portrait(const Problem& problem, int arm, int resolution, const Budget& budget) {
  const Arm loaded = loaded_arm(problem, arm);
  const SingleJointArm system(loaded);
  const Task& task = problem.tasks[arm];
  ArmPortrait portrait = {draw_portrait(system, task.goal, resolution), {}};
  if (budget.exhausted()) return std::nullopt;
  const auto motion = fastest_motion(system, task.start, task.goal, Swings::kSearch, budget);
  if (const auto* blocked = std::get_if<Blocked>(&motion)) {
    const FreeRange whole = {loaded.joint_range, {}, {}, {}, {}};
    const Infeasible refusal = refuse_blocked(loaded, task, system, whole, *blocked, budget);
    portrait.motion = refusal;
    if (!blocked->is_proven) portrait.motion = not_found(refusal, *blocked);
  } else {
    portrait.motion = drawn(std::get<FastestMotion>(motion), resolution);
  }
  if (budget.exhausted()) return std::nullopt;
  return portrait;
}

}  // namespace dualarm

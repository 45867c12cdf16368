#include "core/verification/verify.h"

#include <algorithm>
#include <array>

#include "core/verification/arc_check.h"
#include "core/verification/clearance_check.h"
#include "core/verification/interpolant.h"
#include "core/verification/joint_torque.h"
#include "core/verification/knot_check.h"
#include "core/verification/limit_check.h"
#include "core/verification/needed_torque.h"
#include "core/verification/torque_column.h"

namespace dualarm {
namespace {

void append(std::vector<Violation>& all, const std::vector<Violation>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void keep_larger(Utilisation& kept, const Utilisation& other) {
  if (kept.arm.empty() || other.value > kept.value) kept = other;
}

void add_arm(Verification& verification, const Arm& arm, const ArmTrajectory& trajectory, const Interpolant& motion,
             const Budget& budget) {
  const JointTorque torque(arm);
  const NeededTorque needed(torque, motion);
  const LimitReport limits = check_limits(arm, torque, needed, motion, budget);
  keep_larger(verification.range, limits.range);
  keep_larger(verification.velocity, limits.velocity);
  keep_larger(verification.torque, limits.torque);
  append(verification.violations, limits.violations);
  if (!limits.is_complete) {
    verification.violations.push_back({ViolationKind::kClearanceUnknown,
                                       "the budget ended before the limits of " + arm.name + " were proven", arm.name,
                                       0.0, 0.0, 0.0});
    return;
  }

  const TorqueColumnReport torques = check_torque_column(arm, trajectory.knots, torque, needed, motion);
  verification.max_position_error = std::max(verification.max_position_error, torques.max_position_error);
  append(verification.violations, torques.violations);

  append(verification.violations, check_arcs(trajectory, motion));
}

void add_clearance(Verification& verification, const ClearanceReport& clearance) {
  verification.collision_free = clearance.collision_free;
  verification.min_clearance = clearance.min_clearance;
  verification.closest = clearance.closest;
  verification.distance_query_count = clearance.distance_query_count;
  append(verification.violations, clearance.violations);
}

}  // namespace

Verification verify(const Problem& problem, const Trajectory& trajectory, const Budget& budget,
                    bool check_end_states_too) {
  Verification verification;
  verification.violations = check_knots(problem, trajectory);
  if (!verification.violations.empty()) return verification;

  if (check_end_states_too) append(verification.violations, check_end_states(problem, trajectory));
  const std::array<Interpolant, kArmCount> motions = {Interpolant(trajectory[0].knots),
                                                      Interpolant(trajectory[1].knots)};
  for (int i = 0; i < kArmCount; ++i) add_arm(verification, loaded_arm(problem, i), trajectory[i], motions[i], budget);
  add_clearance(verification, check_clearance(problem, motions, trajectory[0].knots.back().time, budget));
  return verification;
}

}  // namespace dualarm

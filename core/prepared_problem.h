#pragma once

#include <array>

#include "core/coordination/forbidden_set.h"
#include "core/free_range.h"
#include "core/model/problem.h"
#include "core/systems/single_joint_arm.h"

namespace dualarm {

/// What every method asks of a problem, computed once. The problem outlives it.
class PreparedProblem {
 public:
  explicit PreparedProblem(const Problem& problem);
  PreparedProblem(const PreparedProblem&) = delete;  // The systems are pointed at.
  PreparedProblem& operator=(const PreparedProblem&) = delete;

  const Problem& problem() const { return problem_; }

  /// What start and goal leave beyond the demanded clearance, m.
  double slack() const { return slack_; }

  /// What is added to the demanded clearance while planning, m: optimal plans touch the forbidden set, and the proof
  /// that they keep the demanded clearance ends only if there is some room. Theory, section 5.
  double margin() const { return margin_; }

  /// What is planned with, m: the demanded clearance and the margin.
  double clearance() const { return problem_.options.clearance + margin_; }

  const Arm& arm(int i) const { return arms_[i]; }                   ///< with all that it carries
  const FreeRange& free_range(int i) const { return free_[i]; }      ///< at the planning clearance
  const SingleJointArm& system(int i) const { return systems_[i]; }  ///< inside its free range
  const ForbiddenSet& forbidden() const { return forbidden_; }       ///< at the planning clearance

  /// The problem with the ranges that fixed objects leave both arms at a clearance (m).
  Problem within_free_ranges_at(double clearance) const;

  bool has_moving_objects() const { return has_moving_objects_; }

  /// Whether both arms rest at their starts and goals.
  bool rests_at_ends() const;

 private:
  const Problem& problem_;
  double slack_;
  double margin_;
  std::array<Arm, kArmCount> arms_;
  std::array<FreeRange, kArmCount> free_;
  std::array<SingleJointArm, kArmCount> systems_;
  ForbiddenSet forbidden_;
  bool has_moving_objects_;
};

}  // namespace dualarm

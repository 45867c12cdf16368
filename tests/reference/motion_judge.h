#pragma once

#include <string>
#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"
#include "core/model/trajectory.h"

namespace dualarm {

/// What a motion may miss.
struct JudgeTolerances {
  /// Ends are not looked at where a standing arm would magnify roundings by more than e to this on the way.
  double growth = 1e9;
  double duration = 1e-9;      ///< of the duration: times of the arcs beside the judge's own integration
  double instant = 1e-10;      ///< s, beside it: of the times of the shortest motions
  double state = 1e-7;         ///< rad and rad/s: ends of arcs, and the goal after integrating all torques in a row
  double utilisation = 1e-9;   ///< of a limit: by how much it may be exceeded along the motion
  double integration = 1e-17;  ///< rad and rad/s: of one step of the judge's own integration
};

/// What is wrong with a motion from `start` to `goal` under full torques and cruises, in words; empty if nothing. The
/// judge integrates its own equation of motion (OwnEquation), with adaptive steps of Boost.Odeint, over each arc from
/// its start and over all arcs in a row; it looks at times, ends, seams, velocity limits, joint range, and at the
/// torque that a cruise needs. Precondition: at least one arc.
std::vector<std::string> judge_precisely(const Arm& arm, JointState start, JointState goal,
                                         const std::vector<Arc>& arcs, const JudgeTolerances& tolerances = {});

/// The same in double and with less demanding tolerances, for millions of motions: duration 1e-7, state 1e-6,
/// utilisation 1e-7.
std::vector<std::string> judge_quickly(const Arm& arm, JointState start, JointState goal, const std::vector<Arc>& arcs);

}  // namespace dualarm

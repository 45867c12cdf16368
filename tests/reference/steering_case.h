#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "core/phase_plane/time_optimal.h"
#include "tests/reference/random_motions.h"

namespace dualarm {

/// One call of the steering function.
struct SteeringCase {
  MotionProblem problem;
  Swings swings = Swings::kSkip;
  std::uint64_t drive = 0;  ///< not zero: the goal was reached by drive_at_random with this seed
};

/// The call that some bytes stand for: any bytes are a call with finite numbers and valid limits. States lie in, around
/// and at the edges of the joint range; moves can be tiny, velocities at, near or beyond their limits, drives just
/// stronger or weaker than gravity.
SteeringCase steering_case(std::span<const std::uint8_t> bytes);

std::ostream& operator<<(std::ostream& out, const SteeringCase& steering);

/// Makes the call and judges the answer (judge_quickly, and for refusals their reasons by the judges' own equation and
/// integration). What is wrong with it, in words; empty if nothing.
struct SteeringVerdict {
  std::vector<std::string> complaints;
  bool is_motion = false;
};
SteeringVerdict judge_steering(const SteeringCase& steering);

}  // namespace dualarm

#include "core/verification/knot_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/verification/interpolant.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

bool finite(const Knot& knot) {
  return std::isfinite(knot.time) && std::isfinite(knot.position) && std::isfinite(knot.velocity) &&
         std::isfinite(knot.acceleration) && std::isfinite(knot.torque);
}

Violation disorder(const ArmTrajectory& motion, double time, std::string explanation) {
  return {ViolationKind::kKnotOrder, std::move(explanation), motion.arm, time, 0.0, 0.0};
}

/// What is wrong with the times of two knots that are closer than a piece may be.
std::optional<Violation> find_disorder(const ArmTrajectory& motion, std::size_t k) {
  const Knot& before = motion.knots[k - 1];
  const Knot& after = motion.knots[k];
  if (after.time < before.time) {
    return disorder(motion, after.time,
                    sentence("time of ", motion.arm, " runs backwards at knot ", k, ": ", before.time, " s, then ",
                             after.time, " s"));
  }
  if (share_a_time(before, after)) return std::nullopt;
  return disorder(
      motion, after.time,
      sentence("knots ", k - 1, " and ", k, " of ", motion.arm, " at ", after.time, " s are ", after.time - before.time,
               " s apart; knots share a time or are at least ", kShortestPiece, " s apart"));
}

/// The jumps of position and velocity where knots share a time, all together.
struct Jumps {
  double way = 0.0;
  double change = 0.0;
  std::optional<Violation> too_much;

  void add(const ArmTrajectory& motion, const Knot& before, const Knot& after) {
    way += std::abs(after.position - before.position);
    change += std::abs(after.velocity - before.velocity);
    const double jump = std::max(way, change);
    if (jump <= kJumpTolerance || too_much) return;
    too_much = {ViolationKind::kContinuity,
                sentence("jumps of position or velocity of ", motion.arm, " between knots that share a time reach ",
                         jump, " at ", before.time, " s; together they may be ", kJumpTolerance),
                motion.arm,
                before.time,
                jump,
                kJumpTolerance};
  }
};

/// The first knot from one on (not the first of all) that may not be just finite and a piece after the one before.
/// `longest` (s): knots farther apart share no time.
std::size_t next_unusual(std::span<const Knot> knots, double longest, std::size_t k) {
  double before = knots[k - 1].time;
  for (; k < knots.size(); ++k) {
    const Knot& knot = knots[k];
    const double sum = (knot.time + knot.position) + (knot.velocity + knot.acceleration) + knot.torque;
    const bool is_finite = sum - sum == 0.0;
    if (!is_finite || !(knot.time - before > longest)) break;
    before = knot.time;
  }
  return k;
}

/// The first disorder, or else the first jump.
std::optional<Violation> find_fault(const ArmTrajectory& motion) {
  const std::vector<Knot>& knots = motion.knots;
  if (knots.size() < 2) {
    return disorder(motion, 0.0, sentence(motion.arm, " has ", knots.size(), " knots; a motion has at least two"));
  }
  Jumps jumps;
  // Of times that run backwards the last one is not the largest, but they are told in any case.
  const double longest = std::max(kShortestPiece, longest_shared(knots.back().time));
  for (std::size_t k = finite(knots.front()) ? next_unusual(knots, longest, 1) : 0; k < knots.size();
       k = next_unusual(knots, longest, k + 1)) {
    if (!finite(knots[k])) return disorder(motion, 0.0, sentence("knot ", k, " of ", motion.arm, " is not finite"));
    if (!(knots[k].time - knots[k - 1].time >= kShortestPiece)) {
      if (auto found = find_disorder(motion, k)) return found;
    }
    if (share_a_time(knots[k - 1], knots[k])) jumps.add(motion, knots[k - 1], knots[k]);
  }
  if (knots.front().time != 0.0) {
    return disorder(motion, knots.front().time,
                    sentence("knots of ", motion.arm, " begin at ", knots.front().time, " s and not at 0"));
  }
  return std::move(jumps.too_much);
}

std::optional<Violation> compare(const std::string& arm, const char* end, const Knot& knot, const JointState& wanted) {
  const double off = std::max(std::abs(knot.position - wanted.position), std::abs(knot.velocity - wanted.velocity));
  if (off <= kStateTolerance) return std::nullopt;
  return Violation{ViolationKind::kEndState,
                   sentence(arm, " is at ", knot.position, " rad with ", knot.velocity, " rad/s at its ", end,
                            "; the task says ", wanted.position, " rad with ", wanted.velocity, " rad/s"),
                   arm,
                   knot.time,
                   off,
                   kStateTolerance};
}

}  // namespace

std::vector<Violation> check_knots(const Problem& problem, const Trajectory& trajectory) {
  std::vector<Violation> violations;
  for (int i = 0; i < kArmCount; ++i) {
    const std::string& wanted = problem.arms[i].name;
    const ArmTrajectory& motion = trajectory[i];
    if (motion.arm != wanted) {
      violations.push_back({ViolationKind::kArm,
                            sentence("trajectory ", i, " is of '", motion.arm, "' where '", wanted, "' is expected"),
                            motion.arm, 0.0, 0.0, 0.0});
    }
    if (const auto fault = find_fault(motion)) violations.push_back(*fault);
  }
  if (!violations.empty()) return violations;
  const double first_end = trajectory[0].knots.back().time;
  const double second_end = trajectory[1].knots.back().time;
  if (first_end != second_end) {
    violations.push_back({ViolationKind::kKnotOrder,
                          sentence("knots of ", trajectory[0].arm, " end at ", first_end, " s, those of ",
                                   trajectory[1].arm, " at ", second_end, " s"),
                          "", first_end, second_end, first_end});
  }
  return violations;
}

std::vector<Violation> check_end_states(const Problem& problem, const Trajectory& trajectory) {
  std::vector<Violation> violations;
  for (int i = 0; i < kArmCount; ++i) {
    const std::vector<Knot>& knots = trajectory[i].knots;
    const std::string& arm = problem.arms[i].name;
    if (const auto off = compare(arm, "start", knots.front(), problem.tasks[i].start)) violations.push_back(*off);
    if (const auto off = compare(arm, "end", knots.back(), problem.tasks[i].goal)) violations.push_back(*off);
  }
  return violations;
}

}  // namespace dualarm

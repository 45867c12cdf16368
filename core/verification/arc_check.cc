#include "core/verification/arc_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

// Comparisons ask for "within", so that a NaN is never within.
bool within(double value, double wanted, double tolerance) { return std::abs(value - wanted) <= tolerance; }

bool same(const JointState& left, const JointState& right) {
  return within(left.position, right.position, kStateTolerance) &&
         within(left.velocity, right.velocity, kStateTolerance);
}

class ArcCheck {
 public:
  ArcCheck(const ArmTrajectory& trajectory, const Interpolant& motion)
      : trajectory_(trajectory), motion_(motion), end_(trajectory.knots.back().time) {}

  std::optional<Violation> find_break() const {
    double from = 0.0;
    for (std::size_t k = 0; k < trajectory_.arcs.size(); ++k) {
      const Arc& arc = trajectory_.arcs[k];
      if (!within(arc.start_time, from, kTimeTolerance) || !(arc.end_time >= arc.start_time)) {
        return violation(arc.start_time, sentence("arc ", k, " spans ", arc.start_time, " s to ", arc.end_time,
                                                  " s where an arc from ", from, " s is expected"));
      }
      from = arc.end_time;
    }
    if (trajectory_.arcs.empty() || within(from, end_, kTimeTolerance)) return std::nullopt;
    return violation(from, sentence("arcs end at ", from, " s, the plan at ", end_, " s"));
  }

  std::optional<Violation> find_disagreement() const {
    for (std::size_t k = 0; k < trajectory_.arcs.size(); ++k) {
      const Arc& arc = trajectory_.arcs[k];
      if (!same(arc.start, motion_.state(arc.start_time)) || !same(arc.end, motion_.state(arc.end_time))) {
        return violation(arc.start_time, sentence("arc ", k, " does not pass through the states of the knots"));
      }
      if (!keeps_its_kind(arc)) {
        return violation(arc.start_time, sentence("arc ", k, " does not move as its kind says"));
      }
    }
    return std::nullopt;
  }

  std::optional<Violation> find_motion_outside() const {
    const double start = trajectory_.start_time;
    const double duration = trajectory_.duration;
    if (start == 0.0 && duration == 0.0 && trajectory_.arcs.empty()) return std::nullopt;
    if (!(start >= 0.0 && duration >= 0.0 && start + duration <= end_ + kTimeTolerance)) {
      return violation(
          start, sentence("it claims to move for ", duration, " s from ", start, " s, in a plan of ", end_, " s"));
    }
    if (motion_.travel({0.0, start}) <= kStateTolerance &&
        motion_.travel({start + duration, end_}) <= kStateTolerance) {
      return std::nullopt;
    }
    return violation(start, sentence("it moves before ", start, " s or after ", start + duration, " s"));
  }

 private:
  bool keeps_its_kind(const Arc& arc) const {
    if (arc.kind == ArcKind::kHold) return motion_.travel({arc.start_time, arc.end_time}) <= kStateTolerance;
    if (arc.kind == ArcKind::kCruise) return keeps_its_velocity(arc);
    return true;
  }

  bool keeps_its_velocity(const Arc& arc) const {
    const auto first = std::lower_bound(trajectory_.knots.begin(), trajectory_.knots.end(), arc.start_time,
                                        [](const Knot& knot, double time) { return knot.time < time; });
    const auto end = std::upper_bound(first, trajectory_.knots.end(), arc.end_time,
                                      [](double time, const Knot& knot) { return time < knot.time; });
    return within(arc.end.velocity, arc.start.velocity, kStateTolerance) &&
           std::all_of(first, end,
                       [&](const Knot& knot) { return within(knot.velocity, arc.start.velocity, kStateTolerance); });
  }

  Violation violation(double time, const std::string& what) const {
    return {ViolationKind::kArc, trajectory_.arm + ": " + what, trajectory_.arm, time, 0.0, 0.0};
  }

  const ArmTrajectory& trajectory_;
  const Interpolant& motion_;
  double end_;
};

}  // namespace

std::vector<Violation> check_arcs(const ArmTrajectory& trajectory, const Interpolant& motion) {
  const ArcCheck check(trajectory, motion);
  std::vector<Violation> violations;
  if (const auto broken = check.find_break()) {
    violations.push_back(*broken);
  } else if (const auto disagreement = check.find_disagreement()) {
    violations.push_back(*disagreement);
  }
  if (const auto outside = check.find_motion_outside()) violations.push_back(*outside);
  return violations;
}

}  // namespace dualarm

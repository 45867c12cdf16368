#include "core/verification/limit_check.h"

#include <algorithm>
#include <cmath>

#include "core/verification/joint_torque.h"
#include "core/verification/peak.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

Quantity position_along(const Quintic& piece) {
  return {[&piece](double time) { return piece.derivative(0, time); }, [&piece](Interval) { return piece.most(2); },
          0.0};
}

Quantity velocity_along(const Quintic& piece, double most_rounding) {
  return {[&piece](double time) { return piece.derivative(1, time); }, [&piece](Interval) { return piece.most(3); },
          std::min(most_rounding, piece.velocity_rounding())};
}

/// How much rounding of torques a motion is forgiven. Less than the tolerance is free; what is more is a velocity over
/// the time of its piece, and all of them together are a small part of the motion's own.
class Forgiveness {
 public:
  Forgiveness(const Arm& arm, const std::vector<Knot>& knots)
      : free_(kTorqueTolerance * Share::by_side(torque_bounds(arm.torque)).unit()) {
    for (const Knot& knot : knots) left_ = std::max(left_, kMostForgivenVelocity * std::abs(knot.velocity));
  }

  double of(const Quintic& piece, double rounding) {
    if (rounding <= free_) return rounding;
    const double taken = piece.acceleration_rounding() * piece.duration();
    if (!(taken <= left_)) return free_;
    left_ -= taken;
    return rounding;
  }

 private:
  double free_;        // N m
  double left_ = 0.0;  // rad/s
};

/// One limit of one arm: its search, and the words for it.
struct Limit {
  ViolationKind kind;
  const char* quantity;
  const char* unit;
  Interval limits;
  double tolerance;  // share
  PeakSearch search;

  Limit(ViolationKind its_kind, const char* its_quantity, const char* its_unit, Interval its_limits, Share share,
        double its_tolerance)
      : kind(its_kind),
        quantity(its_quantity),
        unit(its_unit),
        limits(its_limits),
        tolerance(its_tolerance),
        search(share, kPeakSlack * its_tolerance) {}

  Utilisation utilisation(const std::string& arm) const { return {search.proven(), arm, search.time()}; }

  void judge(const std::string& arm, std::vector<Violation>& violations) const {
    if (search.proven() <= 1.0 + tolerance) return;
    const double value = search.value();
    const double nearer = value - limits.lower > limits.upper - value ? limits.upper : limits.lower;
    violations.push_back({kind,
                          sentence(quantity, " of ", arm, " at ", search.time(), " s is ", value, " ", unit,
                                   "; its limits are ", limits.lower, " and ", limits.upper, " ", unit),
                          arm, search.time(), value, nearer});
  }
};

}  // namespace

LimitReport check_limits(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion,
                         const Budget& budget) {
  const JointTorque torque_of_motion(arm);
  Limit range(ViolationKind::kJointRange, "position", "rad", arm.joint_range, Share::from_middle(arm.joint_range),
              kStateTolerance / Share::from_middle(arm.joint_range).unit());
  Limit velocity(ViolationKind::kVelocity, "velocity", "rad/s", arm.velocity, Share::by_side(arm.velocity),
                 kVelocityTolerance);
  Limit torque(ViolationKind::kTorque, "torque", "N m", torque_bounds(arm.torque),
               Share::by_side(torque_bounds(arm.torque)), kTorqueTolerance);

  for (const Knot& knot : knots) {
    range.search.visit(knot.time, knot.position);
    velocity.search.visit(knot.time, knot.velocity);
    torque.search.visit(knot.time, torque_of_motion.at(knot.position, knot.acceleration));
  }
  const double most_velocity_rounding = kMostVelocityRounding * Share::by_side(arm.velocity).unit();
  Forgiveness forgiveness(arm, knots);
  bool is_complete = true;
  for (const Quintic& piece : motion.pieces()) {
    is_complete = !budget.exhausted();
    if (!is_complete) break;
    range.search.visit(position_along(piece), piece.time());
    velocity.search.visit(velocity_along(piece, most_velocity_rounding), piece.time());
    Quantity its_torque = torque_of_motion.along(piece);
    its_torque.rounding = forgiveness.of(piece, its_torque.rounding);
    torque.search.visit(its_torque, piece.time());
  }

  LimitReport report = {
      range.utilisation(arm.name), velocity.utilisation(arm.name), torque.utilisation(arm.name), is_complete, {}};
  for (const Limit* limit : {&range, &velocity, &torque}) limit->judge(arm.name, report.violations);
  return report;
}

}  // namespace dualarm

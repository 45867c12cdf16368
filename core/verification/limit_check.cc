#include "core/verification/limit_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "core/verification/joint_torque.h"
#include "core/verification/peak.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"
#include "core/verification/torque_peak.h"

namespace dualarm {
namespace {

Quantity position_along(const Quintic& piece) {
  return {[&piece](double time) { return piece.derivative(0, time); }, [&piece](Interval) { return piece.most(2); },
          0.0};
}

Quantity velocity_along(const Quintic& piece, double rounding) {
  return {[&piece](double time) { return piece.derivative(1, time); }, [&piece](Interval) { return piece.most(3); },
          rounding};
}

/// The least and the largest value at knots, which use more than all between them.
void visit_extremes(PeakSearch& search, const std::vector<Knot>& knots, double Knot::*what) {
  const auto less = [what](const Knot& left, const Knot& right) { return left.*what < right.*what; };
  for (const auto& knot :
       {std::min_element(knots.begin(), knots.end(), less), std::max_element(knots.begin(), knots.end(), less)}) {
    search.visit(knot->time, (*knot).*what);
  }
}

/// How much rounding of torques a motion is forgiven. Less than the tolerance is free; what is more is a velocity over
/// the time of its piece, and all of them together are a small part of the motion's own.
class Forgiveness {
 public:
  Forgiveness(double free, const std::vector<Knot>& knots) : free_(free) {
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

/// What was found of one quantity against its limits.
struct Finding {
  ViolationKind kind;
  const char* quantity;
  const char* unit;
  double tolerance;  // share
  double proven;     // share
  double value;      // where the largest share was seen
  double time;       // s, of that
  Interval limits;   // there
};

Finding find(ViolationKind kind, const char* quantity, const char* unit, double tolerance, const PeakSearch& search,
             Interval limits) {
  return {kind, quantity, unit, tolerance, search.proven(), search.value(), search.time(), limits};
}

void judge(const Finding& found, const std::string& arm, std::vector<Violation>& violations) {
  if (found.proven <= 1.0 + found.tolerance) return;
  const auto [lower, upper] = found.limits;
  const double nearer = found.value - lower > upper - found.value ? upper : lower;
  violations.push_back({found.kind,
                        sentence(found.quantity, " of ", arm, " at ", found.time, " s is ", found.value, " ",
                                 found.unit, "; its limits are ", lower, " and ", upper, " ", found.unit),
                        arm, found.time, found.value, nearer});
}

/// The search of the peak of torque, for limits that stand still and for those that change with the state.
class TorqueLimitSearch {
 public:
  TorqueLimitSearch(const JointTorque& torque, const TorqueLimit& limit) : torque_(torque) {
    if (const auto* constant = std::get_if<Interval>(&limit)) {
      limits_ = *constant;
      constant_.emplace(Share::by_side(limits_), kTorquePeakSlack);
    } else {
      changing_.emplace(torque, limit, kTorquePeakSlack);
    }
  }

  void visit(const Knot& knot) {
    if (changing_) return changing_->visit(knot);
    constant_->visit(knot.time, torque_.at({knot.position, knot.velocity}, knot.acceleration));
  }

  void visit(const Quintic& piece, double rounding) {
    if (changing_) return changing_->visit(piece, rounding);
    const Interval enough = constant_->enough_values();
    const Interval bound = torque_.over(piece, {enough.lower - rounding, enough.upper + rounding});
    if (constant_->visit_range(bound, rounding)) return;
    Quantity along = torque_.along(piece);
    along.rounding = rounding;
    constant_->visit(along, piece.time());
  }

  Finding finding() const {
    if (constant_) return find(ViolationKind::kTorque, "torque", "N m", kTorqueTolerance, *constant_, limits_);
    return {
        ViolationKind::kTorque, "torque",           "N m", kTorqueTolerance, changing_->proven(), changing_->value(),
        changing_->time(),      changing_->limits()};
  }

 private:
  const JointTorque& torque_;
  Interval limits_;  // N m, constant ones
  std::optional<PeakSearch> constant_;
  std::optional<TorquePeakSearch> changing_;
};

}  // namespace

LimitReport check_limits(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion,
                         const Budget& budget) {
  const JointTorque torque_of_motion(arm);
  const Share share_of_range = Share::from_middle(arm.joint_range);
  const Share share_of_velocity = Share::by_side(arm.velocity);
  const double range_tolerance = kStateTolerance / share_of_range.unit();
  PeakSearch range(share_of_range, kPeakSlack * range_tolerance);
  PeakSearch velocity(share_of_velocity, kPeakSlack * kVelocityTolerance);
  TorqueLimitSearch torque(torque_of_motion, arm.torque);

  visit_extremes(range, knots, &Knot::position);
  visit_extremes(velocity, knots, &Knot::velocity);
  for (const Knot& knot : knots) torque.visit(knot);
  const double most_velocity_rounding = kMostVelocityRounding * share_of_velocity.unit();
  Forgiveness forgiveness(kTorqueTolerance * least_half_width(arm.torque), knots);
  bool is_complete = true;
  for (const Quintic& piece : motion.pieces()) {
    is_complete = !budget.exhausted();
    if (!is_complete) break;
    if (!range.visit_range(piece.range(0), 0.0)) range.visit(position_along(piece), piece.time());
    const double velocity_rounding = std::min(most_velocity_rounding, piece.velocity_rounding());
    if (!velocity.visit_range(piece.range(1), velocity_rounding)) {
      velocity.visit(velocity_along(piece, velocity_rounding), piece.time());
    }
    torque.visit(piece, forgiveness.of(piece, torque_of_motion.rounding(piece)));
  }

  const std::array<Finding, 3> findings = {
      find(ViolationKind::kJointRange, "position", "rad", range_tolerance, range, arm.joint_range),
      find(ViolationKind::kVelocity, "velocity", "rad/s", kVelocityTolerance, velocity, arm.velocity),
      torque.finding()};
  const auto utilisation = [&arm](const Finding& found) { return Utilisation{found.proven, arm.name, found.time}; };
  LimitReport report = {utilisation(findings[0]), utilisation(findings[1]), utilisation(findings[2]), is_complete, {}};
  for (const Finding& found : findings) judge(found, arm.name, report.violations);
  return report;
}

}  // namespace dualarm

#include "core/verification/limit_check.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

#include "core/verification/lanes.h"
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

/// The least and the largest of some values; neither is a number where one of them is none.
Interval extremes_of(std::span<const double> values) {
  struct Gathered {
    Lanes lowest;
    Lanes highest;
    Lanes doubt;  // 0 while all are finite
  };
  Gathered found = {widened(values.front()), widened(values.front()), Lanes()};
  gather_lanes(
      values.size(), found, [&]<typename Number>(std::size_t i, Gathered & so_far) __attribute__((always_inline)) {
        const Lanes now = widened(load<Number>(values.data() + i));
        so_far.lowest = lesser<Lanes>(so_far.lowest, now);
        so_far.highest = greater<Lanes>(so_far.highest, now);
        so_far.doubt = so_far.doubt + (now - now);
      });
  if (sum_of(found.doubt) == 0.0) return {least_of(found.lowest), most_of(found.highest)};
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  return {all.minCoeff<Eigen::PropagateNaN>(), all.maxCoeff<Eigen::PropagateNaN>()};
}

/// The least and the largest value at knots, which use more than all between them.
void visit_extremes(PeakSearch& search, std::span<const double> times, std::span<const double> values) {
  const Interval extremes = extremes_of(values);
  for (const double value : {extremes.lower, extremes.upper}) {
    const auto at = std::find(values.begin(), values.end(), value);  // nowhere if it is not a number
    search.visit(at == values.end() ? times.front() : times[at - values.begin()], value);
  }
}

/// How much rounding of torques a motion is forgiven. Less than the tolerance is free; what is more is a velocity over
/// the time of its piece, and all of them together are a small part of the motion's own.
class Forgiveness {
 public:
  Forgiveness(double free, std::span<const double> velocities) : free_(free) {
    const auto [least, most] = std::minmax_element(velocities.begin(), velocities.end());
    left_ = kMostForgivenVelocity * std::max(-*least, *most);
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
  TorqueLimitSearch(const JointTorque& torque, const NeededTorque& needed, const Arm& arm, const Interpolant& motion)
      : torque_(torque),
        needed_(needed),
        motion_(motion),
        free_rounding_(kTorqueTolerance * least_half_width(arm.torque)) {
    if (const auto* constant = std::get_if<Interval>(&arm.torque)) {
      limits_ = *constant;
      constant_.emplace(Share::by_side(limits_), kTorquePeakSlack);
      visit_extremes(*constant_, motion.times(), needed.at_knots());
    } else {
      changing_.emplace(torque, arm.torque, kTorquePeakSlack);
      for (std::size_t k = 0; k < motion.times().size(); ++k) {
        changing_->visit(motion.times()[k], {motion.positions()[k], motion.velocities()[k]}, needed.at_knots()[k]);
      }
    }
  }

  /// All of the motion at once, if that is proof enough.
  bool visit_range() { return constant_ && constant_->visit_range(needed_.range(), 0.0); }

  void visit(std::size_t index) {
    if (constant_ && constant_->visit_range(needed_.range(index), 0.0)) return;
    const Quintic piece = motion_.piece(index);
    if (!forgiveness_) forgiveness_.emplace(free_rounding_, motion_.velocities());
    const double rounding = forgiveness_->of(piece, torque_.rounding(piece));
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
  const NeededTorque& needed_;
  const Interpolant& motion_;
  double free_rounding_;                    // N m
  std::optional<Forgiveness> forgiveness_;  // most motions need none
  Interval limits_;                         // N m, constant ones
  std::optional<PeakSearch> constant_;
  std::optional<TorquePeakSearch> changing_;
};

/// Calls visit(index of a piece) for all of a motion, until the budget ends: false then.
template <typename Visit>
bool visit_pieces(const Interpolant& motion, const Budget& budget, Visit visit) {
  for (std::size_t index = 0; index < motion.piece_count(); ++index) {
    if (budget.exhausted()) return false;
    visit(index);
  }
  return true;
}

}  // namespace

LimitReport check_limits(const Arm& arm, const JointTorque& torque, const NeededTorque& needed,
                         const Interpolant& motion, const Budget& budget) {
  const Share share_of_range = Share::from_middle(arm.joint_range);
  const Share share_of_velocity = Share::by_side(arm.velocity);
  const double range_tolerance = kStateTolerance / share_of_range.unit();
  PeakSearch range(share_of_range, kPeakSlack * range_tolerance);
  PeakSearch velocity(share_of_velocity, kPeakSlack * kVelocityTolerance);
  TorqueLimitSearch torque_search(torque, needed, arm, motion);
  visit_extremes(range, motion.times(), motion.positions());
  visit_extremes(velocity, motion.times(), motion.velocities());

  const auto visit_position = [&](std::size_t index) {
    if (range.visit_range(motion.position_range(index), 0.0)) return;
    const Quintic piece = motion.piece(index);
    range.visit(position_along(piece), piece.time());
  };
  const double most_velocity_rounding = kMostVelocityRounding * share_of_velocity.unit();
  const auto visit_velocity = [&](std::size_t index) {
    if (velocity.visit_range(motion.velocity_range(index), 0.0)) return;
    const Quintic piece = motion.piece(index);
    velocity.visit(velocity_along(piece, std::min(most_velocity_rounding, piece.velocity_rounding())), piece.time());
  };
  // Of most motions all pieces at once are proof enough.
  const bool is_complete =
      !budget.exhausted() &&
      (range.visit_range(motion.position_range(), 0.0) || visit_pieces(motion, budget, visit_position)) &&
      (velocity.visit_range(motion.velocity_range(), 0.0) || visit_pieces(motion, budget, visit_velocity)) &&
      (torque_search.visit_range() ||
       visit_pieces(motion, budget, [&](std::size_t index) { torque_search.visit(index); }));

  const std::array<Finding, 3> findings = {
      find(ViolationKind::kJointRange, "position", "rad", range_tolerance, range, arm.joint_range),
      find(ViolationKind::kVelocity, "velocity", "rad/s", kVelocityTolerance, velocity, arm.velocity),
      torque_search.finding()};
  const auto utilisation = [&arm](const Finding& found) { return Utilisation{found.proven, arm.name, found.time}; };
  LimitReport report = {utilisation(findings[0]), utilisation(findings[1]), utilisation(findings[2]), is_complete, {}};
  for (const Finding& found : findings) judge(found, arm.name, report.violations);
  return report;
}

}  // namespace dualarm

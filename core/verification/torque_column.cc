#include "core/verification/torque_column.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/joint_torque.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

/// N m; infinite where the motion needs no number.
double mismatch(const Knot& knot, const JointTorque& needed) {
  const double difference = std::abs(knot.torque - needed.at({knot.position, knot.velocity}, knot.acceleration));
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

/// What a residual torque of 1 N m does within `time` of a knot at most, rad, where friction lets velocities grow by a
/// factor.
double departure_within(double time, double growth, const JointTorque& torque) {
  const double inertia = torque.inertia() / growth;
  if (!(inertia > 0.0)) return std::numeric_limits<double>::infinity();
  const double y = 0.5 * time * std::sqrt(std::abs(torque.gravity_amplitude()) / inertia);
  const double of_gravity = y > 0.0 ? std::sinh(y) / y : 1.0;
  return (2.0 * time) * (2.0 * time) / (8.0 * inertia) * of_gravity * of_gravity;
}

/// The bound of the header for one piece, rad per N m of E. Longer pieces have larger ones.
double departure(double duration, const JointTorque& torque) {
  const double growth = std::exp(0.5 * duration * torque.friction() / torque.inertia());
  const double from_both_knots = departure_within(0.5 * duration, growth, torque);
  return torque.friction() == 0.0 ? from_both_knots
                                  : std::min(from_both_knots, departure_within(duration, 1.0, torque));
}

/// The largest departure, over pieces with their residual torques. Of pieces h long departure(h) / h^2 is no more than
/// that of the longest one: the exponentials are only worth their time where the piece could be the worst one.
class LargestDeparture {
 public:
  LargestDeparture(const JointTorque& torque, const Interpolant& motion) : torque_(torque) {
    double longest = 0.0;
    for (const Quintic& piece : motion.pieces()) longest = std::max(longest, piece.duration());
    if (longest > 0.0) most_per_square_ = departure(longest, torque) / (longest * longest) * kRoundedUp;
    pieces_.reserve(motion.pieces().size());
  }

  void visit(double residual, double duration) {
    if (residual != 0.0) pieces_.push_back({residual, duration, residual * most_per_square_ * duration * duration});
  }

  double largest() const {
    const auto worst = std::max_element(pieces_.begin(), pieces_.end(),
                                        [](const Piece& left, const Piece& right) { return left.most < right.most; });
    double largest = worst == pieces_.end() ? 0.0 : exactly(*worst);
    for (const Piece& piece : pieces_) {
      if (!(piece.most <= largest)) largest = std::max(largest, exactly(piece));
    }
    return largest;
  }

 private:
  static constexpr double kRoundedUp = 1.0 + 1e-12;

  struct Piece {
    double residual;  // N m
    double duration;  // s
    double most;      // rad
  };

  double exactly(const Piece& piece) const { return piece.residual * departure(piece.duration, torque_); }

  const JointTorque& torque_;
  double most_per_square_ = 0.0;
  std::vector<Piece> pieces_;
};

}  // namespace

TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion) {
  const JointTorque needed(arm);
  TorqueColumnReport report;
  std::size_t worst = 0;
  double largest_share = 0.0;
  std::size_t next_piece = 0;
  LargestDeparture departure(needed, motion);
  double next_mismatch = mismatch(knots.front(), needed);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const double mismatch_here = next_mismatch;
    const double share = mismatch_here / torque_limits(arm.torque, knots[k].position, knots[k].velocity).length();
    if (share > largest_share) {
      worst = k;
      largest_share = share;
    }
    if (k + 1 == knots.size()) break;
    next_mismatch = mismatch(knots[k + 1], needed);
    if (share_a_time(knots[k], knots[k + 1])) continue;
    const Quintic& piece = motion.pieces()[next_piece++];
    const double h = piece.duration();
    const double most_change = needed.most_second_derivative(piece) * h * h / 8.0;
    departure.visit(most_change + std::max(mismatch_here, next_mismatch), h);
  }
  report.max_position_error = departure.largest();
  if (largest_share > kTorqueColumnTolerance) {
    const Knot& knot = knots[worst];
    const double value = needed.at({knot.position, knot.velocity}, knot.acceleration);
    report.violations.push_back({ViolationKind::kTorqueColumn,
                                 sentence("torque of ", arm.name, " is written as ", knot.torque, " N m at ", knot.time,
                                          " s; its motion needs ", value, " N m"),
                                 arm.name, knot.time, knot.torque, value});
  }
  return report;
}

}  // namespace dualarm

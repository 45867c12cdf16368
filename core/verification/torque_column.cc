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

/// What a residual torque does within `time` of a knot at most, rad, where friction lets velocities grow by a factor.
double departure_within(double time, double growth, double residual, const JointTorque& torque) {
  const double inertia = torque.inertia() / growth;
  const double y = 0.5 * time * std::sqrt(std::abs(torque.gravity_amplitude()) / inertia);
  const double of_gravity = y > 0.0 ? std::sinh(y) / y : 1.0;
  return residual * (2.0 * time) * (2.0 * time) / (8.0 * inertia) * of_gravity * of_gravity;
}

/// The bound of the header for one piece; `residual` is E.
double departure(double residual, double duration, const JointTorque& torque) {
  if (residual == 0.0) return 0.0;
  const double growth = std::exp(0.5 * duration * torque.friction() / torque.inertia());
  const double from_both_knots = departure_within(0.5 * duration, growth, residual, torque);
  return torque.friction() == 0.0 ? from_both_knots
                                  : std::min(from_both_knots, departure_within(duration, 1.0, residual, torque));
}

}  // namespace

TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion) {
  const JointTorque needed(arm);
  TorqueColumnReport report;
  std::size_t worst = 0;
  double largest_share = 0.0;
  std::size_t next_piece = 0;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const double share =
        mismatch(knots[k], needed) / torque_limits(arm.torque, knots[k].position, knots[k].velocity).length();
    if (share > largest_share) {
      worst = k;
      largest_share = share;
    }
    if (k + 1 == knots.size() || share_a_time(knots[k], knots[k + 1])) continue;
    const Quintic& piece = motion.pieces()[next_piece++];
    const double h = piece.duration();
    const double residual = needed.along(piece).curvature(piece.time()) * h * h / 8.0 +
                            std::max(mismatch(knots[k], needed), mismatch(knots[k + 1], needed));
    report.max_position_error = std::max(report.max_position_error, departure(residual, h, needed));
  }
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

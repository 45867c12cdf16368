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
  const double difference = std::abs(knot.torque - needed.at(knot.position, knot.acceleration));
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

/// The bound of the header for one piece; `residual` is E.
double departure(double residual, double duration, const JointTorque& torque) {
  if (residual == 0.0) return 0.0;
  const double y = 0.25 * duration * std::sqrt(std::abs(torque.gravity_amplitude()) / torque.inertia());
  const double growth = y > 0.0 ? std::sinh(y) / y : 1.0;
  return residual * duration * duration / (8.0 * torque.inertia()) * growth * growth;
}

}  // namespace

TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const Interpolant& motion) {
  const JointTorque needed(arm);
  TorqueColumnReport report;
  std::size_t worst = 0;
  std::size_t next_piece = 0;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (mismatch(knots[k], needed) > mismatch(knots[worst], needed)) worst = k;
    if (k + 1 == knots.size() || share_a_time(knots[k], knots[k + 1])) continue;
    const Quintic& piece = motion.pieces()[next_piece++];
    const double h = piece.duration();
    const double residual = needed.along(piece).curvature(piece.time()) * h * h / 8.0 +
                            std::max(mismatch(knots[k], needed), mismatch(knots[k + 1], needed));
    report.max_position_error = std::max(report.max_position_error, departure(residual, h, needed));
  }
  const double tolerance = kTorqueColumnTolerance * torque_bounds(arm.torque).length();
  const Knot& knot = knots[worst];
  if (mismatch(knot, needed) > tolerance) {
    const double value = needed.at(knot.position, knot.acceleration);
    report.violations.push_back({ViolationKind::kTorqueColumn,
                                 sentence("torque of ", arm.name, " is written as ", knot.torque, " N m at ", knot.time,
                                          " s; its motion needs ", value, " N m"),
                                 arm.name, knot.time, knot.torque, value});
  }
  return report;
}

}  // namespace dualarm

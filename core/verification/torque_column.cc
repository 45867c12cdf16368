#include "core/verification/torque_column.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <variant>

#include "core/verification/lanes.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

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

using Column = Eigen::Map<const Eigen::ArrayXd>;

Column column(std::span<const double> numbers) { return {numbers.data(), static_cast<Eigen::Index>(numbers.size())}; }

/// Where the largest of some numbers stands.
std::size_t index_of_largest(const Eigen::ArrayXd& numbers) {
  const double* const first = numbers.data();
  return static_cast<std::size_t>(std::find(first, first + numbers.size(), numbers.maxCoeff()) - first);
}

/// How far (N m) the written torque is from the one that the motion needs, at each knot; infinite where one of them is
/// not a number.
Eigen::ArrayXd mismatches(const std::vector<Knot>& knots, const NeededTorque& needed) {
  const std::span<const double> at_knots = needed.at_knots();
  Eigen::ArrayXd off(static_cast<Eigen::Index>(at_knots.size()));
  double* const first = off.data();
  for (std::size_t k = 0; k < at_knots.size(); ++k) first[k] = or_infinite(std::abs(knots[k].torque - at_knots[k]));
  return off;
}

/// The largest residual torque (N m) of each piece.
Eigen::ArrayXd residuals(const NeededTorque& needed, const Eigen::ArrayXd& mismatches, const Interpolant& motion) {
  Eigen::ArrayXd residuals(static_cast<Eigen::Index>(motion.piece_count()));
  for (const Interpolant::Run& run : motion.runs()) {
    const double* const off = mismatches.data() + run.first_knot;
    const double* const departure = needed.departures_from_chord().data() + run.first_piece;
    double* const residual = residuals.data() + run.first_piece;
    for_lanes(
        run.piece_count, [=]<typename Number>(std::size_t i) __attribute__((always_inline)) {
          const Number of_knots = greater<Number>(load<Number>(off + i), load<Number>(off + i + 1));
          store<Number>(residual + i, or_infinite<Number>(load<Number>(departure + i)) + of_knots);
        });
  }
  return residuals;
}

/// The bound of the header over all pieces. Of pieces h long departure(h) / h^2 is no more than that of the longest
/// one: the exponentials are only worth their time where the piece could be the worst one.
double largest_departure(const JointTorque& torque, const Eigen::ArrayXd& residuals, const Interpolant& motion) {
  if (motion.piece_count() == 0) return 0.0;
  constexpr double kRoundedUp = 1.0 + 1e-12;
  const Column durations = column(motion.durations());
  const double longest = durations.maxCoeff();
  const double most_per_square = departure(longest, torque) / (longest * longest) * kRoundedUp;
  const Eigen::ArrayXd squares = residuals * durations * durations;
  const auto exactly = [&](Eigen::Index i) {
    return residuals[i] == 0.0 ? 0.0 : residuals[i] * departure(durations[i], torque);
  };
  const auto worst = static_cast<Eigen::Index>(index_of_largest(squares));
  double largest = exactly(worst);
  if (squares[worst] * most_per_square <= largest) return largest;
  for (Eigen::Index i = 0; i < squares.size(); ++i) {
    if (!(squares[i] * most_per_square <= largest)) largest = std::max(largest, exactly(i));
  }
  return largest;
}

/// The knot whose written torque is the farthest share of its limits' width from the one needed, and that share.
struct WorstKnot {
  std::size_t index = 0;
  double share = 0.0;
};

WorstKnot worst_knot(const Arm& arm, const Interpolant& motion, const Eigen::ArrayXd& mismatches) {
  if (const auto* constant = std::get_if<Interval>(&arm.torque)) {
    const double share = mismatches.maxCoeff() / constant->length();
    return {share > kTorqueColumnTolerance ? index_of_largest(mismatches) : 0, share};
  }
  WorstKnot worst;
  for (std::size_t k = 0; k < motion.times().size(); ++k) {
    const double width = torque_limits(arm.torque, motion.positions()[k], motion.velocities()[k]).length();
    const double share = mismatches[static_cast<Eigen::Index>(k)] / width;
    if (share > worst.share) worst = {k, share};
  }
  return worst;
}

}  // namespace

TorqueColumnReport check_torque_column(const Arm& arm, const std::vector<Knot>& knots, const JointTorque& torque,
                                       const NeededTorque& needed, const Interpolant& motion) {
  TorqueColumnReport report;
  const Eigen::ArrayXd off = mismatches(knots, needed);
  report.max_position_error = largest_departure(torque, residuals(needed, off, motion), motion);
  const WorstKnot worst = worst_knot(arm, motion, off);
  if (worst.share > kTorqueColumnTolerance) {
    const Knot& knot = knots[worst.index];
    const double value = needed.at_knots()[worst.index];
    report.violations.push_back({ViolationKind::kTorqueColumn,
                                 sentence("torque of ", arm.name, " is written as ", knot.torque, " N m at ", knot.time,
                                          " s; its motion needs ", value, " N m"),
                                 arm.name, knot.time, knot.torque, value});
  }
  return report;
}

}  // namespace dualarm

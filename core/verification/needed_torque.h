#pragma once

#include <Eigen/Core>
#include <span>

#include "core/verification/interpolant.h"
#include "core/verification/joint_torque.h"

namespace dualarm {

/// The torque that a motion needs, at all of its knots and along all of its pieces.
///
/// Along a piece of h s it is taken as the quintic with the torque's values and derivatives of order 1 and 2 at both
/// knots. Of inertia and friction, which are polynomials of lower degree, that is exact; of gravity's sine it leaves at
/// most h^6 / 46080 times the sixth derivative (theory, section 5). A quintic lies between the least and the largest of
/// its Bernstein coefficients, and no farther from its chord than these from the chord's own. Where fastest motions
/// have the torque constant while inertia and gravity change against each other, that is tight to rounding and to how
/// well the knots keep it.
class NeededTorque {
 public:
  NeededTorque(const JointTorque& torque, const Interpolant& motion);

  /// Of the knots, N m.
  std::span<const double> at_knots() const { return column(knots_, 0); }

  /// N m, over a whole piece; no numbers where numbers overflow.
  Interval range(std::size_t piece) const { return {column(pieces_, 0)[piece], column(pieces_, 1)[piece]}; }

  /// N m, over all pieces; infinite where numbers overflow, empty without pieces.
  Interval range() const { return range_; }

  /// Of the pieces, N m: how far the torque is at most from going straight from the one knot's to the other's.
  std::span<const double> departures_from_chord() const { return column(pieces_, 2); }

 private:
  static std::span<const double> column(const Eigen::ArrayXXd& columns, Eigen::Index index) {
    return {columns.col(index).data(), static_cast<std::size_t>(columns.rows())};
  }

  void take_knots(const JointTorque& torque, const Interpolant& motion);
  void bound_pieces(const JointTorque& torque, const Interpolant& motion);

  Eigen::ArrayXXd knots_;   // torque; what gravity and friction change it by at first, and gravity's second derivative
  Eigen::ArrayXXd pieces_;  // lowest, highest, departure from the chord
  Interval range_;
};

}  // namespace dualarm

#pragma once

#include "core/verification/interpolant.h"
#include "core/verification/joint_torque.h"
#include "core/verification/limit_cells.h"
#include "core/verification/peak.h"

namespace dualarm {

/// Half the width (N m) of torque limits where they are narrowest.
double least_half_width(const TorqueLimit& limit);

/// Searches the largest share of its torque limits that a motion uses where the limits change with its position and
/// velocity, and proves it: what PeakSearch does for limits that stand still.
///
/// Fastest motions ride on the limit, where torque and limit change together. So the proof is about their difference,
///   D(t) = tau(t) - [limit at a share of sigma](theta(t), omega(t)),
/// with sigma a little above the share attained: over an interval of length h, D stays within (bound on |D''|) h^2 / 8
/// of its chord, and D'' is known in the middle, where its parts cancel, and changes by at most (bound on |D'''|) h
/// / 2. Between bends the limit is bilinear and D smooth. Where an interval crosses a bend, the limit of the cell of
/// its middle is continued, and the largest departure of the true limit from that, over all states that the interval
/// can reach, is added: an error that falls with the interval, down to nothing where knots stand on the bends.
///
/// Shares as by Share: by side if the limits contain zero everywhere, from their middle otherwise.
class TorquePeakSearch {
 public:
  /// `torque` outlives this. The proven peak exceeds the attained one by at most `slack` (share, relative above 1).
  TorquePeakSearch(const JointTorque& torque, const TorqueLimit& limit, double slack);

  /// A state that is passed at a time (s), and the torque (N m) that the motion needs there.
  void visit(double time, JointState state, double torque);

  /// All that happens along a piece of motion; `rounding` (N m) of its torque is forgiven.
  void visit(const Quintic& piece, double rounding);

  double proven() const { return proven_; }    ///< upper bound on the share
  double value() const { return value_; }      ///< N m, where the largest share was seen
  Interval limits() const { return limits_; }  ///< N m, there
  double time() const { return time_; }        ///< s, where that is

 private:
  struct Instant {
    double time;  // s
    JointState state;
    double torque;  // N m
  };

  Instant instant(const Quintic& piece, double time) const;
  Share share_at(Interval limits) const;
  void attain(const Instant& at, double rounding);
  void search(const Quintic& piece, double rounding, const Instant& start, const Instant& end, int halvings);
  double bound(const Quintic& piece, double rounding, const Instant& start, const Instant& end, const Instant& middle,
               double aim) const;

  const JointTorque& torque_;
  LimitCells cells_;
  bool is_by_side_;
  double slack_;
  int intervals_left_ = 0;  // of a piece
  double attained_ = -1.0;
  double proven_ = 0.0;
  double value_ = 0.0;
  Interval limits_;
  double time_ = 0.0;
};

}  // namespace dualarm

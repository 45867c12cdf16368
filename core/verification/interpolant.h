#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/model/trajectory.h"
#include "core/verification/quintic.h"
#include "geometry/interval.h"

namespace dualarm {

/// One arm's motion as it is sent: quintics one after the other, none where two knots share a time. Outside of its
/// time it stays at its ends.
///
/// What is asked of all knots or of all pieces stands in columns, one number after the other. Bounds are the least and
/// the largest Bernstein coefficient of a piece, between which the quintic lies; infinite where numbers overflow.
class Interpolant {
 public:
  /// Precondition: at least one knot; numbers finite, times not decreasing.
  explicit Interpolant(const std::vector<Knot>& knots);

  /// Of the knots: s, rad, rad/s, rad/s2.
  std::span<const double> times() const { return of_knots(kTime); }
  std::span<const double> positions() const { return of_knots(kPosition); }
  std::span<const double> velocities() const { return of_knots(kVelocity); }
  std::span<const double> accelerations() const { return of_knots(kAcceleration); }

  /// Knots one after the other with a piece between each two, as many as can be.
  struct Run {
    std::size_t first_knot = 0;
    std::size_t first_piece = 0;
    std::size_t piece_count = 0;
  };
  const std::vector<Run>& runs() const { return runs_; }

  std::size_t piece_count() const { return piece_count_; }
  Quintic piece(std::size_t index) const;

  /// Of the pieces: s; rad/s2, the inner two of the four Bernstein coefficients of the acceleration; rad/s and rad/s2,
  /// upper bounds on speed and acceleration.
  std::span<const double> durations() const { return of_pieces(kDuration); }
  std::span<const double> second_accelerations() const { return of_pieces(kSecond); }
  std::span<const double> third_accelerations() const { return of_pieces(kThird); }
  std::span<const double> speeds() const { return of_pieces(kSpeed); }
  std::span<const double> most_accelerations() const { return of_pieces(kMostAcceleration); }

  /// Of one piece, rad and rad/s.
  Interval position_range(std::size_t piece) const { return range(piece, kLowest, kHighest); }
  Interval velocity_range(std::size_t piece) const { return range(piece, kSlowest, kFastest); }

  /// Of all pieces together; empty without pieces.
  Interval position_range() const { return position_range_; }
  Interval velocity_range() const { return velocity_range_; }

  JointState state(double time) const;

  /// Upper bound (rad) on the way the joint goes, to and fro, during an interval of time.
  double travel(Interval time) const;

  /// Upper bounds on speed (rad/s) and acceleration (rad/s2) during an interval of time.
  struct Bounds {
    double speed = 0.0;
    double acceleration = 0.0;
  };
  Bounds bounds(Interval time) const;

  /// What is asked of an interval of time at once.
  struct During {
    JointState in_the_middle;
    double farthest = 0.0;  ///< rad, bound on the way from where it is in the middle to where it is at any other time
    Bounds most;
  };
  During during(Interval time) const;

 private:
  enum KnotColumn { kTime, kPosition, kVelocity, kAcceleration, kKnotColumns };
  enum PieceColumn {
    kStart,
    kDuration,
    kSecond,
    kThird,
    kLowest,
    kHighest,
    kSlowest,
    kFastest,
    kSpeed,
    kMostAcceleration,
    kTravelled,  // at its end
    kPieceColumns
  };

  std::span<const double> of_knots(KnotColumn column) const {
    return {knots_.col(column).data(), static_cast<std::size_t>(knots_.rows())};
  }
  std::span<const double> of_pieces(PieceColumn column) const { return {pieces_.col(column).data(), piece_count_}; }
  Interval range(std::size_t piece, PieceColumn lower, PieceColumn upper) const {
    return {of_pieces(lower)[piece], of_pieces(upper)[piece]};
  }

  void take(const std::vector<Knot>& knots);
  void bound_pieces();
  void overflow();
  void summarise();
  Knot knot(std::size_t index) const;
  std::size_t knot_before(std::size_t piece) const;
  std::size_t piece_at(double time) const;
  JointState state(std::size_t piece, double time) const;
  double travelled(std::size_t piece, double time) const;
  double travel(std::size_t first, std::size_t last, Interval time) const;
  Bounds bounds(std::size_t first, std::size_t last, Interval time) const;

  Eigen::ArrayXXd knots_;
  Eigen::ArrayXXd pieces_;
  Eigen::ArrayX2d blocks_;  // speeds and accelerations of a number of pieces together: long motions are bounded quickly
  std::vector<Run> runs_;
  std::size_t piece_count_ = 0;
  Interval position_range_;
  Interval velocity_range_;
};

}  // namespace dualarm

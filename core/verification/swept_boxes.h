#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/verification/carried_body.h"

namespace dualarm {

/// Slices of time for which a body's boxes are kept: enough that what a link goes during one is small beside its
/// length, few enough that all of them cost no more than some distance queries.
inline constexpr int kSlices = 16;

/// Boxes along the world's axes that contain a body all the time: one for all of a span of time, and one for each of
/// kSlices equal parts of it, which are made when somebody asks. m.
class SweptBoxes {
 public:
  /// The body outlives this. Precondition: time.lower <= time.upper.
  SweptBoxes(const CarriedBody& body, Interval time);

  const CarriedBody& body() const { return *body_; }
  const Eigen::AlignedBox3d& whole() const { return whole_; }

  /// The boxes of all slices, or the whole one alone where the body does not move.
  const std::vector<Eigen::AlignedBox3d>& slices();

 private:
  const CarriedBody* body_;
  Interval time_;
  Eigen::AlignedBox3d whole_;
  std::vector<Eigen::AlignedBox3d> slices_;
};

/// Lower bound (m, >= 0 less rounding) on the distance of two bodies at any time of one span: that of the whole boxes
/// where this is `enough`, else that of the slices.
double distance_of_boxes(SweptBoxes& first, SweptBoxes& second, double enough);

}  // namespace dualarm

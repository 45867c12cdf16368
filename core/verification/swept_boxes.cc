#include "core/verification/swept_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/tolerances.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

using Box3d = Eigen::AlignedBox3d;

Box3d box_around(const Shape& shape) {
  Box3d box;
  for (int i = 0; i < 3; ++i) {
    box.extend(farthest_point(shape, Eigen::Vector3d::Unit(i)));
    box.extend(farthest_point(shape, -Eigen::Vector3d::Unit(i)));
  }
  return box;
}

/// The box of where the body is in the middle, wider by the way it goes; a joint moves nothing upwards.
Box3d box_during(const CarriedBody& body, Interval time) {
  Box3d box = box_around(shape_at(body, 0.5 * (time.lower + time.upper)));
  const double way = farthest_way(body, time);
  const double way_upwards = std::holds_alternative<CarryingJoint>(body.carrier) ? 0.0 : way;
  const Eigen::Vector3d ways(way, way, way_upwards);
  return {box.min() - ways, box.max() + ways};
}

double gap(const Box3d& first, const Box3d& second) { return std::sqrt(first.squaredExteriorDistance(second)); }

}  // namespace

SweptBoxes::SweptBoxes(const CarriedBody& body, Interval time)
    : body_(&body), time_(time), whole_(box_during(body, time)) {}

const std::vector<Box3d>& SweptBoxes::slices() {
  if (!slices_.empty()) return slices_;
  if (farthest_way(*body_, time_) == 0.0) {
    slices_ = {whole_};
    return slices_;
  }
  const auto cut = [&](int i) { return i < kSlices ? time_.lower + i * time_.length() / kSlices : time_.upper; };
  whole_.setEmpty();
  for (int i = 0; i < kSlices; ++i) {
    slices_.push_back(box_during(*body_, {cut(i), cut(i + 1)}));
    whole_.extend(slices_.back());
  }
  return slices_;
}

double distance_of_boxes(SweptBoxes& first, SweptBoxes& second, double enough) {
  const double of_whole = gap(first.whole(), second.whole()) - kSeparationRounding;
  if (of_whole >= enough) return of_whole;
  const std::vector<Box3d>& firsts = first.slices();
  const std::vector<Box3d>& seconds = second.slices();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::max(firsts.size(), seconds.size()); ++i) {
    least = std::min(least, gap(firsts[firsts.size() > 1 ? i : 0], seconds[seconds.size() > 1 ? i : 0]));
  }
  return least - kSeparationRounding;
}

}  // namespace dualarm

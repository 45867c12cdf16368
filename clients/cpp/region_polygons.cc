#include "clients/cpp/region_polygons.h"

#include <algorithm>

#include "clients/cpp/wording.h"

namespace dualarm {

using namespace planning::v1;

PlotRange in_degrees(const JointRange& range) { return {to_degrees(range.min_rad()), to_degrees(range.max_rad())}; }

PlotPoint in_degrees(double theta1, double theta2) { return {to_degrees(theta1), to_degrees(theta2)}; }

std::vector<std::vector<PlotPoint>> polygons_of(const GetForbiddenRegionResponse& region) {
  std::vector<std::vector<PlotPoint>> polygons;
  for (const Contour& contour : region.contours()) {
    std::vector<PlotPoint>& polygon = polygons.emplace_back();
    for (int k = 0; k < std::min(contour.theta1_rad_size(), contour.theta2_rad_size()); ++k) {
      polygon.push_back(in_degrees(contour.theta1_rad(k), contour.theta2_rad(k)));
    }
  }
  return polygons;
}

double area_of(const std::vector<std::vector<PlotPoint>>& polygons) {
  double twice = 0.0;
  for (const auto& polygon : polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const PlotPoint& next = polygon[(k + 1) % polygon.size()];
      twice += polygon[k].x * next.y - polygon[k].y * next.x;
    }
  }
  return 0.5 * twice;
}

}  // namespace dualarm

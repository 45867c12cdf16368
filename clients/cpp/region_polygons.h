// A forbidden region as it is drawn.
#pragma once

#include <vector>

#include "clients/cpp/plot_view.h"
#include "dualarm/planning/v1/planning_service.pb.h"

namespace dualarm {

/// A joint range as an axis in degrees.
PlotRange in_degrees(const planning::v1::JointRange& range);

/// Two joint positions (rad) as a point in degrees.
PlotPoint in_degrees(double theta1, double theta2);

/// The region's contours in degrees.
std::vector<std::vector<PlotPoint>> polygons_of(const planning::v1::GetForbiddenRegionResponse& region);

/// What the polygons hold by the even-odd rule, where each has its inside on its left: square units.
double area_of(const std::vector<std::vector<PlotPoint>>& polygons);

}  // namespace dualarm

#include "clients/cpp/region_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "clients/cpp/region_polygons.h"
#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

std::string extent(const std::vector<std::vector<PlotPoint>>& polygons, double PlotPoint::*coordinate) {
  if (polygons.empty()) return "-";
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const auto& polygon : polygons) {
    for (const PlotPoint& point : polygon) {
      least = std::min(least, point.*coordinate);
      most = std::max(most, point.*coordinate);
    }
  }
  return fmt::format("{:.4f} to {:.4f} deg", least, most);
}

std::string row(const RegionSet& set) {
  const auto polygons = polygons_of(set.region);
  const PlotRange x = in_degrees(set.region.theta1_range());
  const PlotRange y = in_degrees(set.region.theta2_range());
  const double area = area_of(polygons);
  return fmt::format("  {:<24} {:>14} {:>9} {:>16} {:>9}   {:<26} {:<26}\n", set.name, clearance(set.clearance_m),
                     polygons.size(), fmt::format("{:.2f} deg2", area),
                     percent(area / ((x.max - x.min) * (y.max - y.min))), extent(polygons, &PlotPoint::x),
                     extent(polygons, &PlotPoint::y));
}

}  // namespace

std::string region_report(const std::string& name, const PlanMotionRequest& scenario,
                          const std::vector<RegionSet>& sets) {
  const bool has_arms = scenario.robot().arms_size() == 2;
  const std::string first = has_arms ? scenario.robot().arms(0).name() : "arm 1";
  const std::string second = has_arms ? scenario.robot().arms(1).name() : "arm 2";
  std::string text = fmt::format("{}: where {} and {} collide\n\n", name, first, second);
  text += fmt::format("  {:<24} {:>14} {:>9} {:>16} {:>9}   {:<26} {:<26}\n", "set", "clearance", "contours", "area",
                      "share", "theta1, " + first, "theta2, " + second);
  for (auto set = sets.rbegin(); set != sets.rend(); ++set) text += row(*set);
  for (const std::string& sentence : left_out(scenario)) text += fmt::format("\n  {}\n", sentence);
  return text;
}

}  // namespace dualarm

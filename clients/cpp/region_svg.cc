#include "clients/cpp/region_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "clients/cpp/region_polygons.h"
#include "clients/cpp/svg_plot.h"
#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr double kMarginDegrees = 10.0;

constexpr const char* kExact = "fill:#e4572e;fill-opacity:0.75;stroke:#a83210;stroke-width:1.4;stroke-linejoin:round";
constexpr const char* kExactWithMargin =
    "fill:#e4572e;fill-opacity:0.3;stroke:#c23b18;stroke-width:1.2;stroke-dasharray:6 4;stroke-linejoin:round";
constexpr const char* kPaper = "fill:#3d7ea6;fill-opacity:0.3;stroke:#14507a;stroke-width:1.4;stroke-linejoin:round";
constexpr const char* kPaperWithMargin =
    "fill:#3d7ea6;fill-opacity:0.14;stroke:#14507a;stroke-width:1.2;stroke-dasharray:6 4;stroke-linejoin:round";

const char* style_of(const RegionSet& set) {
  if (set.is_paper) return set.clearance_m > 0.0 ? kPaperWithMargin : kPaper;
  return set.clearance_m > 0.0 ? kExactWithMargin : kExact;
}

std::string subtitle_of(const PlanMotionRequest& scenario) {
  const double margin = scenario.options().clearance_m();
  return margin > 0.0 ? "safety margin: a clearance of " + clearance(margin) : "no safety margin is demanded";
}

}  // namespace

std::string region_svg(const std::string& name, const PlanMotionRequest& scenario, const std::vector<RegionSet>& sets) {
  const bool has_arms = scenario.robot().arms_size() == 2;
  const std::string first = has_arms ? scenario.robot().arms(0).name() : "arm 1";
  const std::string second = has_arms ? scenario.robot().arms(1).name() : "arm 2";
  std::vector<std::vector<PlotPoint>> lines;
  for (const RegionSet& set : sets) {
    for (auto& polygon : polygons_of(set.region)) lines.push_back(std::move(polygon));
  }
  const GetForbiddenRegionResponse& any = sets.front().region;
  SvgPlot plot(plot_view(lines, {in_degrees(any.theta1_range()), in_degrees(any.theta2_range())}, kMarginDegrees),
               "theta1, " + first + " [deg]", "theta2, " + second + " [deg]");
  plot.title(name + ": where the arms collide", subtitle_of(scenario));
  for (const RegionSet& set : sets) plot.fill(polygons_of(set.region), style_of(set));
  for (auto set = sets.rbegin(); set != sets.rend(); ++set) {
    plot.legend(fmt::format("<rect y=\"1\" width=\"28\" height=\"12\" rx=\"2\" style=\"{}\"/>", style_of(*set)),
                set->region.contours().empty() ? set->name + ": empty" : set->name);
  }
  for (const std::string& sentence : left_out(scenario)) plot.note(sentence);
  return plot.document();
}

}  // namespace dualarm

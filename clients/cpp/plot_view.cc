#include "clients/cpp/plot_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr PlotRange kNothing = {kInfinity, -kInfinity};

void include(PlotRange& range, double value) {
  range.min = std::min(range.min, value);
  range.max = std::max(range.max, value);
}

PlotRange framed(const PlotRange& range, const PlotRange& limits, double margin) {
  if (range.min > range.max) return limits;
  return {std::max(limits.min, margin * std::floor(range.min / margin - 0.5)),
          std::min(limits.max, margin * std::ceil(range.max / margin + 0.5))};
}

}  // namespace

PlotView plot_view(const std::vector<std::vector<PlotPoint>>& lines, const PlotView& limits, double margin) {
  PlotView view{kNothing, kNothing};
  for (const auto& line : lines) {
    for (const PlotPoint& point : line) {
      include(view.x, point.x);
      include(view.y, point.y);
    }
  }
  return {framed(view.x, limits.x, margin), framed(view.y, limits.y, margin)};
}

}  // namespace dualarm

// Which part of a plane a drawing shows.
#pragma once

#include <vector>

namespace dualarm {

/// A point in the plot's own units.
struct PlotPoint {
  double x;
  double y;
};

struct PlotRange {
  double min;
  double max;
};

struct PlotView {
  PlotRange x;
  PlotRange y;
};

/// The least view that holds all `lines` with half a `margin` to spare, its ends at whole multiples of `margin`; cut
/// off at `limits`. Where there are no points it is the limits.
PlotView plot_view(const std::vector<std::vector<PlotPoint>>& lines, const PlotView& limits, double margin);

}  // namespace dualarm

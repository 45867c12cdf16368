// A square plot with axes, as SVG text: knows drawing, no arms.
#pragma once

#include <string>
#include <vector>

#include "clients/cpp/plot_view.h"

namespace dualarm {

/// How long the axes are: of equal scales, so that the longer range fills the side, or each as long as the plot.
enum class PlotScales { kEqual, kFilled };

/// Draws in the order of the calls. Numbers become pixels with two decimals.
class SvgPlot {
 public:
  /// The axes' ranges (min < max) and their titles.
  SvgPlot(const PlotView& view, const std::string& x_title, const std::string& y_title,
          PlotScales scales = PlotScales::kEqual);

  /// Polygons filled by the even-odd rule, as one shape.
  void fill(const std::vector<std::vector<PlotPoint>>& polygons, const std::string& style);
  void polyline(const std::vector<PlotPoint>& points, const std::string& style);
  void circle(PlotPoint centre, double radius_pixels, const std::string& style);
  /// Two lines of text above the plot.
  void title(const std::string& title, const std::string& subtitle);
  /// An entry of the legend on the right: a sample of `symbol` (SVG elements drawn in a box of 28 by 14 pixels whose
  /// upper left corner is the origin) and its text.
  void legend(const std::string& symbol, const std::string& text);
  /// A line of small text under the legend.
  void note(const std::string& text);

  /// The whole document.
  std::string document() const;

 private:
  double pixel_x(double x) const;
  double pixel_y(double y) const;
  std::string path_data(const std::vector<PlotPoint>& points) const;
  void draw_axes(const std::string& x_title, const std::string& y_title);

  PlotView view_;
  double x_scale_;  ///< pixels per unit
  double y_scale_;
  std::string back_;
  std::string inside_;  ///< clipped to the plot's frame
  std::string outside_;
  double next_legend_y_;
};

}  // namespace dualarm

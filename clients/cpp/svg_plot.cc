#include "clients/cpp/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dualarm {
namespace {

// Layout in pixels.
constexpr double kSide = 560.0;
constexpr double kHeight = 400.0;  // where the axes have scales of their own
constexpr double kLeft = 76.0;
constexpr double kTop = 84.0;
constexpr double kBottom = 64.0;
constexpr double kLegendWidth = 260.0;
constexpr double kLegendGap = 24.0;
constexpr double kLineHeight = 26.0;

constexpr const char* kStyleSheet =
    "text{font-family:'Helvetica Neue',Helvetica,Arial,'DejaVu Sans',sans-serif;fill:#22303c}"
    ".title{font-size:20px;font-weight:600}.subtitle{font-size:13px;fill:#5b6b79}"
    ".tick{font-size:12px;fill:#5b6b79}.axis{font-size:14px}.legend{font-size:13px}.note{font-size:12px;fill:#5b6b79}";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string text_at(double x, double y, const std::string& attributes, const std::string& text) {
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", x, y, attributes, escaped(text));
}

// The smallest round step that leaves at most ten ticks; from 1 to 180 one that suits degrees.
double tick_step(PlotRange range) {
  constexpr std::array kSteps = {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0};
  const double least = (range.max - range.min) / 10.0;
  const double decade = std::pow(10.0, std::ceil(std::log10(least)));
  if (decade <= 1.0) {
    const double share = least / decade;
    return decade * (share <= 0.1 ? 0.1 : share <= 0.2 ? 0.2 : share <= 0.5 ? 0.5 : 1.0);
  }
  const auto step = std::find_if(kSteps.begin(), kSteps.end(), [least](double s) { return s >= least; });
  return step != kSteps.end() ? *step : decade;
}

std::vector<double> ticks(PlotRange range) {
  const double step = tick_step(range);
  std::vector<double> values;
  for (double k = std::ceil(range.min / step - 1e-9); k * step <= range.max + 1e-9 * step; k += 1.0) {
    values.push_back(k * step + 0.0);
  }
  return values;
}

}  // namespace

SvgPlot::SvgPlot(const PlotView& view, const std::string& x_title, const std::string& y_title, PlotScales scales)
    : view_(view),
      x_scale_(kSide / (view.x.max - view.x.min)),
      y_scale_(kHeight / (view.y.max - view.y.min)),
      next_legend_y_(kTop + 8.0) {
  if (scales == PlotScales::kEqual) {
    x_scale_ = kSide / std::max(view.x.max - view.x.min, view.y.max - view.y.min);
    y_scale_ = x_scale_;
  }
  draw_axes(x_title, y_title);
}

double SvgPlot::pixel_x(double x) const { return kLeft + x_scale_ * (x - view_.x.min); }

double SvgPlot::pixel_y(double y) const { return kTop + y_scale_ * (view_.y.max - y); }

// Points that fall on the pixel before them are left out.
std::string SvgPlot::path_data(const std::vector<PlotPoint>& points) const {
  std::string data;
  std::string last;
  for (const PlotPoint& point : points) {
    std::string next = fmt::format("{:.2f},{:.2f}", pixel_x(point.x), pixel_y(point.y));
    if (next == last) continue;
    data += (data.empty() ? "M" : " ") + next;
    last = std::move(next);
  }
  return data;
}

void SvgPlot::draw_axes(const std::string& x_title, const std::string& y_title) {
  const double right = pixel_x(view_.x.max);
  const double bottom = pixel_y(view_.y.min);
  back_ += fmt::format("<g stroke=\"#e6ebef\" stroke-width=\"1\">\n");
  for (const double x : ticks(view_.x)) {
    back_ += fmt::format("<path d=\"M{0:.2f},{1:.2f} {0:.2f},{2:.2f}\"/>\n", pixel_x(x), kTop, bottom);
    outside_ += text_at(pixel_x(x), bottom + 18.0, "class=\"tick\" text-anchor=\"middle\"", fmt::format("{:g}", x));
  }
  for (const double y : ticks(view_.y)) {
    back_ += fmt::format("<path d=\"M{1:.2f},{0:.2f} {2:.2f},{0:.2f}\"/>\n", pixel_y(y), kLeft, right);
    outside_ += text_at(kLeft - 8.0, pixel_y(y) + 4.0, "class=\"tick\" text-anchor=\"end\"", fmt::format("{:g}", y));
  }
  back_ += "</g>\n";
  outside_ += fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" stroke=\"#8a99a6\"/>\n", kLeft,
      kTop, right - kLeft, bottom - kTop);
  outside_ += text_at((kLeft + right) / 2.0, bottom + 44.0, "class=\"axis\" text-anchor=\"middle\"", x_title);
  outside_ += fmt::format("<g transform=\"translate(26 {:.2f}) rotate(-90)\">{}</g>\n", (kTop + bottom) / 2.0,
                          text_at(0.0, 0.0, "class=\"axis\" text-anchor=\"middle\"", y_title));
}

void SvgPlot::fill(const std::vector<std::vector<PlotPoint>>& polygons, const std::string& style) {
  std::string data;
  for (const auto& polygon : polygons) data += path_data(polygon) + "Z ";
  inside_ += fmt::format("<path d=\"{}\" fill-rule=\"evenodd\" style=\"{}\"/>\n", data, style);
}

void SvgPlot::polyline(const std::vector<PlotPoint>& points, const std::string& style) {
  inside_ += fmt::format("<path d=\"{}\" style=\"fill:none;{}\"/>\n", path_data(points), style);
}

void SvgPlot::circle(PlotPoint centre, double radius_pixels, const std::string& style) {
  outside_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" style=\"{}\"/>\n", pixel_x(centre.x),
                          pixel_y(centre.y), radius_pixels, style);
}

void SvgPlot::title(const std::string& title, const std::string& subtitle) {
  outside_ += text_at(kLeft, 36.0, "class=\"title\"", title) + text_at(kLeft, 60.0, "class=\"subtitle\"", subtitle);
}

void SvgPlot::legend(const std::string& symbol, const std::string& text) {
  const double x = pixel_x(view_.x.max) + kLegendGap;
  outside_ += fmt::format("<g transform=\"translate({:.2f} {:.2f})\">{}</g>\n", x, next_legend_y_, symbol);
  outside_ += text_at(x + 38.0, next_legend_y_ + 11.5, "class=\"legend\"", text);
  next_legend_y_ += kLineHeight;
}

void SvgPlot::note(const std::string& text) {
  outside_ += text_at(pixel_x(view_.x.max) + kLegendGap, next_legend_y_ + 16.0, "class=\"note\"", text);
  next_legend_y_ += 18.0;
}

std::string SvgPlot::document() const {
  const double width = pixel_x(view_.x.max) + kLegendGap + kLegendWidth;
  const double height = pixel_y(view_.y.min) + kBottom;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n"
      "<style>{2}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
      "<clipPath id=\"frame\"><rect x=\"{3:.2f}\" y=\"{4:.2f}\" width=\"{5:.2f}\" height=\"{6:.2f}\"/></clipPath>\n"
      "{7}<g clip-path=\"url(#frame)\">\n{8}</g>\n{9}</svg>\n",
      width, height, kStyleSheet, kLeft, kTop, pixel_x(view_.x.max) - kLeft, pixel_y(view_.y.min) - kTop, back_,
      inside_, outside_);
}

}  // namespace dualarm

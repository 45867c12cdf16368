#include "clients/cpp/portrait_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "clients/cpp/plot_view.h"
#include "clients/cpp/portrait_report.h"
#include "clients/cpp/svg_plot.h"
#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr const char* kLimit = "stroke:#8a99a6;stroke-width:2;stroke-linejoin:round";
constexpr const char* kSwitching = "stroke:#8e44ad;stroke-width:2;stroke-dasharray:7 4;stroke-linejoin:round";
constexpr const char* kAxis = "stroke:#b8c4cd;stroke-width:1.2";
constexpr const char* kTurn = "fill:#ffffff;stroke:#22303c;stroke-width:1.4";
constexpr const char* kStart = "fill:#ffffff;stroke:#22303c;stroke-width:3.5";
constexpr const char* kGoal = "fill:#22303c;stroke:#ffffff;stroke-width:1.5";

constexpr double kSidewards = 0.2;  // of the motion's extent, shown on either side of it
constexpr double kUpwards = 1.4;    // of its largest speed
// Everything is shown where it is at most this many times as large as the motion.
constexpr double kMostRoom = 5.0;

std::string arc_style(ArcKind kind) {
  const char* colour = kind == ARC_KIND_ACCELERATE ? "#1b8a5a" : kind == ARC_KIND_BRAKE ? "#c23b18" : "#14507a";
  return fmt::format("stroke:{};stroke-width:3.4;stroke-linejoin:round;stroke-linecap:round", colour);
}

PlotPoint point_of(double position, double velocity) { return {to_degrees(position), velocity}; }

PlotPoint point_of(const JointState& state) { return point_of(state.position_rad(), state.velocity_rad_per_s()); }

std::vector<PlotPoint> points_of(const PhaseCurve& curve) {
  std::vector<PlotPoint> points;
  for (int k = 0; k < std::min(curve.position_rad_size(), curve.velocity_rad_per_s_size()); ++k) {
    points.push_back(point_of(curve.position_rad(k), curve.velocity_rad_per_s(k)));
  }
  return points;
}

// A limit curve leaves out what is not safe: it is drawn in pieces of even spacing.
std::vector<std::vector<PlotPoint>> pieces_of(const PhaseCurve& curve) {
  const std::vector<PlotPoint> points = points_of(curve);
  double spacing = HUGE_VAL;
  for (std::size_t k = 1; k < points.size(); ++k) spacing = std::min(spacing, points[k].x - points[k - 1].x);
  std::vector<std::vector<PlotPoint>> pieces;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == 0 || points[k].x - points[k - 1].x > 1.5 * spacing) pieces.emplace_back();
    pieces.back().push_back(points[k]);
  }
  return pieces;
}

// The points of the motion that belong to an arc.
std::vector<PlotPoint> points_of(const Arc& arc, const PhaseCurve& motion) {
  std::vector<PlotPoint> points = {point_of(arc.start())};
  for (int k = 0; k < std::min(motion.time_s_size(), motion.position_rad_size()); ++k) {
    if (motion.time_s(k) <= arc.start_time_s() || motion.time_s(k) >= arc.end_time_s()) continue;
    points.push_back(point_of(motion.position_rad(k), motion.velocity_rad_per_s(k)));
  }
  points.push_back(point_of(arc.end()));
  return points;
}

PlotRange extent(const std::vector<PlotPoint>& points, double PlotPoint::*coordinate) {
  PlotRange range = {points.front().*coordinate, points.front().*coordinate};
  for (const PlotPoint& point : points) {
    range = {std::min(range.min, point.*coordinate), std::max(range.max, point.*coordinate)};
  }
  return range;
}

PlotRange widened(PlotRange range, double margin) {
  const double least = 1e-6 * (1.0 + std::abs(range.min));  // a range must not be a point
  return {range.min - std::max(margin, least), range.max + std::max(margin, least)};
}

// The motion with some room around it, but not beyond the limits; without a motion everything.
PlotView view_of(const ArmTask& task, const GetPhasePortraitResponse& response) {
  std::vector<PlotPoint> motion = {point_of(task.start()), point_of(task.goal())};
  std::vector<PlotPoint> everything = motion;
  for (const PhaseCurve& curve : response.curves()) {
    const std::vector<PlotPoint> points = points_of(curve);
    everything.insert(everything.end(), points.begin(), points.end());
    if (curve.kind() == PHASE_CURVE_KIND_FASTEST_MOTION) motion.insert(motion.end(), points.begin(), points.end());
  }
  const PlotRange all_x = extent(everything, &PlotPoint::x);
  const PlotRange all_y = extent(everything, &PlotPoint::y);
  const PlotView whole = {widened(all_x, 0.02 * (all_x.max - all_x.min)),
                          widened(all_y, 0.1 * (all_y.max - all_y.min))};
  const PlotRange near_x = extent(motion, &PlotPoint::x);
  const PlotRange near_y = extent(motion, &PlotPoint::y);
  const double fastest = std::max(-near_y.min, near_y.max);
  const bool fits =
      all_x.max - all_x.min <= kMostRoom * (near_x.max - near_x.min) && all_y.max - all_y.min <= kMostRoom * fastest;
  if (response.arcs().empty() || fits) return whole;
  const double margin = kSidewards * (near_x.max - near_x.min);
  return {{std::max(whole.x.min, near_x.min - margin), std::min(whole.x.max, near_x.max + margin)},
          {std::max(whole.y.min, -kUpwards * fastest), std::min(whole.y.max, kUpwards * fastest)}};
}

void line_legend(SvgPlot& plot, const std::string& style, const std::string& text) {
  plot.legend(fmt::format("<path d=\"M0,7 28,7\" style=\"fill:none;{}\"/>", style), text);
}

void draw_limits(SvgPlot& plot, const GetPhasePortraitResponse& response) {
  for (const PhaseCurve& curve : response.curves()) {
    if (curve.kind() != PHASE_CURVE_KIND_UPPER_LIMIT && curve.kind() != PHASE_CURVE_KIND_LOWER_LIMIT) continue;
    for (const auto& piece : pieces_of(curve)) plot.polyline(piece, kLimit);
  }
  line_legend(plot, kLimit, "limits");
}

void draw_switching_curve(SvgPlot& plot, const GetPhasePortraitResponse& response) {
  bool is_there = false;
  for (const PhaseCurve& curve : response.curves()) {
    if (curve.kind() != PHASE_CURVE_KIND_SWITCHING) continue;
    plot.polyline(points_of(curve), kSwitching);
    is_there = true;
  }
  if (is_there) line_legend(plot, kSwitching, "switching curve of the goal");
}

void draw_motion(SvgPlot& plot, const GetPhasePortraitResponse& response) {
  const auto& curves = response.curves();
  const auto motion = std::find_if(curves.begin(), curves.end(), [](const PhaseCurve& curve) {
    return curve.kind() == PHASE_CURVE_KIND_FASTEST_MOTION;
  });
  if (motion == curves.end()) return;
  for (const Arc& arc : response.arcs()) plot.polyline(points_of(arc, *motion), arc_style(arc.kind()));
  for (int k = 1; k < response.arcs_size(); ++k) plot.circle(point_of(response.arcs(k).start()), 3.5, kTurn);
  for (const ArcKind kind : {ARC_KIND_ACCELERATE, ARC_KIND_CRUISE, ARC_KIND_BRAKE}) {
    const auto& arcs = response.arcs();
    if (std::any_of(arcs.begin(), arcs.end(), [kind](const Arc& arc) { return arc.kind() == kind; })) {
      line_legend(plot, arc_style(kind), "fastest motion: " + words_for(kind));
    }
  }
  if (response.arcs_size() > 1) {
    plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"3.5\" style=\"{}\"/>", kTurn), "switch");
  }
}

void draw_ends(SvgPlot& plot, const ArmTask& task) {
  plot.circle(point_of(task.start()), 7.0, kStart);
  plot.circle(point_of(task.goal()), 7.5, kGoal);
  plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"6\" style=\"{}\"/>", kStart), "start");
  plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"6.5\" style=\"{}\"/>", kGoal), "goal");
}

std::string title_of(const std::string& name, const ArmTask& task, const GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) {
    return fmt::format("{}, {}: no motion, {}", name, task.arm(), words_for(response.infeasible().reason()));
  }
  if (response.has_undecided()) return fmt::format("{}, {}: undecided", name, task.arm());
  return fmt::format("{}, {}: {:.4f} s", name, task.arm(), response.duration_s());
}

}  // namespace

std::string portrait_svg(const std::string& name, const ArmTask& task, const GetPhasePortraitResponse& response) {
  const PlotView view = view_of(task, response);
  SvgPlot plot(view, "position of " + task.arm() + " [deg]", "velocity [rad/s]", PlotScales::kFilled);
  const bool has_motion = !response.has_infeasible() && !response.has_undecided();
  plot.title(title_of(name, task, response), has_motion ? claim_sentence(response) : "");
  plot.polyline({{view.x.min, 0.0}, {view.x.max, 0.0}}, kAxis);
  draw_limits(plot, response);
  draw_motion(plot, response);
  draw_switching_curve(plot, response);  // over the motion, which ends on it
  draw_ends(plot, task);
  return plot.document();
}

}  // namespace dualarm

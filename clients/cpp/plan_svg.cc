#include "clients/cpp/plan_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "clients/cpp/motion_curve.h"
#include "clients/cpp/plot_view.h"
#include "clients/cpp/region_polygons.h"
#include "clients/cpp/svg_plot.h"
#include "clients/cpp/wording.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr int kPathPoints = 2001;
constexpr int kRegionResolution = 361;  // two points a degree over half a turn

constexpr double kMarginDegrees = 10.0;

constexpr const char* kForbidden =
    "fill:#e4572e;fill-opacity:0.28;stroke:#c23b18;stroke-width:1.2;stroke-linejoin:round";
constexpr const char* kPath = "stroke:#14507a;stroke-width:3;stroke-linejoin:round;stroke-linecap:round";
constexpr const char* kBeat = "fill:#ffffff;stroke:#14507a;stroke-width:1.4";
constexpr const char* kStart = "fill:#ffffff;stroke:#1b8a5a;stroke-width:3.5";
constexpr const char* kGoal = "fill:#1b8a5a;stroke:#ffffff;stroke-width:1.5";

// The tasks' states in the order of the robot's arms.
PlotPoint position_of(const PlanMotionRequest& request, bool at_goal) {
  std::array<double, 2> theta{};
  for (const ArmTask& task : request.tasks()) {
    for (int arm = 0; arm < std::min(2, request.robot().arms_size()); ++arm) {
      if (request.robot().arms(arm).name() != task.arm()) continue;
      theta[static_cast<std::size_t>(arm)] = (at_goal ? task.goal() : task.start()).position_rad();
    }
  }
  return in_degrees(theta[0], theta[1]);
}

std::string title_of(const std::string& name, const PlanMotionResponse& response) {
  if (response.has_plan()) {
    return fmt::format("{}: {} plan, {:.4f} s", name, words_for(response.plan().method()),
                       response.plan().duration_s());
  }
  if (response.has_infeasible()) return fmt::format("{}: no plan, {}", name, words_for(response.infeasible().reason()));
  return fmt::format("{}: {}", name, response.has_undecided() ? "undecided" : "validated only");
}

std::string subtitle_of(const PlanMotionResponse& response) {
  if (!response.has_plan()) return "";
  const Plan& plan = response.plan();
  return fmt::format("lower bound {:.4f} s, gap {:.2f} %; closest approach {}", plan.certificate().lower_bound_s(),
                     100.0 * plan.certificate().gap(), clearance(plan.verification().min_clearance_m()));
}

// A round span of time that fits 8 to 20 times into the plan.
double beat_of(double duration_s) {
  double beat = 1e-3;
  for (int k = 0; duration_s / beat > 20.0; ++k) beat *= k % 3 == 1 ? 2.5 : 2.0;
  return beat;
}

std::vector<PlotPoint> points_of(const PlanMotionResponse& response) {
  std::vector<PlotPoint> points;
  if (response.plan().trajectories_size() != 2) return points;
  const Plan& plan = response.plan();
  for (const PathPoint& point :
       path_of(plan.trajectories(0).knots(), plan.trajectories(1).knots(), plan.duration_s(), kPathPoints)) {
    points.push_back(in_degrees(point.theta1, point.theta2));
  }
  return points;
}

void draw_path(SvgPlot& plot, const Plan& plan, const std::vector<PlotPoint>& path) {
  if (path.empty()) return;
  plot.polyline(path, kPath);
  plot.legend(fmt::format("<path d=\"M0,7 28,7\" style=\"{}\"/>", kPath), "path of the plan");
  const Knots& first = plan.trajectories(0).knots();
  const Knots& second = plan.trajectories(1).knots();
  const double beat = beat_of(plan.duration_s());
  for (double time = beat; time < plan.duration_s(); time += beat) {
    plot.circle(in_degrees(position_at(first, time), position_at(second, time)), 3.0, kBeat);
  }
  plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"3\" style=\"{}\"/>", kBeat),
              fmt::format("every {:g} s", beat));
}

void draw_ends(SvgPlot& plot, const PlanMotionRequest& request) {
  plot.circle(position_of(request, false), 7.0, kStart);
  plot.circle(position_of(request, true), 7.5, kGoal);
  plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"6\" style=\"{}\"/>", kStart), "start");
  plot.legend(fmt::format("<circle cx=\"14\" cy=\"7\" r=\"6.5\" style=\"{}\"/>", kGoal), "goal");
}

void note_waiting(SvgPlot& plot, const Plan& plan) {
  for (const ArmTrajectory& arm : plan.trajectories()) {
    plot.note(fmt::format("{}:", arm.arm()));
    plot.note(fmt::format("waits {:.4f} s, moves for {:.4f} s", arm.start_time_s(), arm.duration_s()));
  }
}

}  // namespace

GetForbiddenRegionRequest region_request_for(const PlanMotionRequest& request) {
  GetForbiddenRegionRequest region;
  *region.mutable_robot() = request.robot();
  if (request.has_scene()) *region.mutable_scene() = request.scene();
  region.set_clearance_m(request.options().clearance_m());
  region.set_region_model(request.options().region_model());
  region.set_resolution(kRegionResolution);
  return region;
}

std::string plan_svg(const std::string& name, const PlanMotionRequest& request, const PlanMotionResponse& response,
                     const GetForbiddenRegionResponse& region) {
  const std::string first = request.robot().arms_size() == 2 ? request.robot().arms(0).name() : "arm 1";
  const std::string second = request.robot().arms_size() == 2 ? request.robot().arms(1).name() : "arm 2";
  const std::vector<PlotPoint> path = points_of(response);
  const auto polygons = polygons_of(region);
  auto lines = polygons;
  lines.push_back(path);
  lines.push_back({position_of(request, false), position_of(request, true)});
  SvgPlot plot(plot_view(lines, {in_degrees(region.theta1_range()), in_degrees(region.theta2_range())}, kMarginDegrees),
               "theta1, " + first + " [deg]", "theta2, " + second + " [deg]");
  plot.title(title_of(name, response), subtitle_of(response));
  plot.fill(polygons, kForbidden);
  plot.legend(fmt::format("<rect y=\"1\" width=\"28\" height=\"12\" rx=\"2\" style=\"{}\"/>", kForbidden),
              "forbidden: too close");
  draw_path(plot, response.plan(), path);
  draw_ends(plot, request);
  if (response.has_plan()) note_waiting(plot, response.plan());
  return plot.document();
}

}  // namespace dualarm

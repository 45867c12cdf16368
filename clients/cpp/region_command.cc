#include "clients/cpp/region_command.h"

#include <CLI/CLI.hpp>

#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/region_report.h"
#include "clients/cpp/region_sets.h"
#include "clients/cpp/region_svg.h"
#include "clients/cpp/standard_output.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr int kResolution = 361;  // two points a degree over half a turn

}  // namespace

void RegionCommand::add_to(CLI::App& command) {
  command.add_option("FILE", file, "a request (PlanMotionRequest as JSON, see scenarios/); - is stdin")->required();
  command.add_flag(
      "--json", json,
      "print the set that a plan of FILE has to avoid (GetForbiddenRegionResponse) as JSON and nothing else");
  command.add_option("--svg", svg,
                     "draw the exact set and the paper's, as they are and with the clearance, into this file");
  command.add_option("--resolution", resolution, "grid points a joint range, 2 to 2000 (361 where it is not given)");
  add_connection_options(command, connection);
  command.footer(
      "Fixed and moving objects are left out: they are in the way of one arm, or have a clock of their own.\n"
      "Exit status: 0 done, 2 usage or invalid request, 4 no answer in time, 5 server not reachable.");
}

ExitStatus RegionCommand::run(const Interruption& interruption) const {
  PlanMotionRequest scenario;
  read_json(file, scenario);
  const PlanningClient client(connection, interruption.token());
  const int points = resolution == 0 ? kResolution : resolution;
  if (json) {
    print(json_of(client.forbidden_region(
        region_request(scenario, scenario.options().region_model(), scenario.options().clearance_m(), points))));
    if (svg.empty()) return ExitStatus::kDone;
  }
  const auto sets = region_sets(
      scenario, points, [&](const GetForbiddenRegionRequest& request) { return client.forbidden_region(request); });
  const std::string name = name_of_file(file);
  if (!json) print(region_report(name, scenario, sets));
  if (!svg.empty()) write_text(svg, region_svg(name, scenario, sets));
  return ExitStatus::kDone;
}

}  // namespace dualarm

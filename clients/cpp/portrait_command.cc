#include "clients/cpp/portrait_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/portrait_report.h"
#include "clients/cpp/portrait_svg.h"
#include "clients/cpp/standard_output.h"

namespace dualarm {
namespace {

using namespace planning::v1;

GetPhasePortraitRequest request_from(const std::string& file, const std::string& arm, int resolution) {
  PlanMotionRequest scenario;
  read_json(file, scenario);
  GetPhasePortraitRequest request;
  *request.mutable_robot() = scenario.robot();
  if (scenario.has_scene()) *request.mutable_scene() = scenario.scene();
  request.set_resolution(resolution);
  std::string names;
  for (const ArmTask& task : scenario.tasks()) {
    if (task.arm() == arm) *request.mutable_task() = task;
    names += (names.empty() ? "" : " or ") + task.arm();
  }
  if (!request.has_task()) {
    throw CommandError(ExitStatus::kInvalid,
                       fmt::format("{}: has no task for arm '{}': give --arm {}", shown_path(file), arm, names));
  }
  return request;
}

ExitStatus exit_status_of(const GetPhasePortraitResponse& response) {
  if (response.has_infeasible()) return ExitStatus::kNegative;
  if (response.has_undecided()) return ExitStatus::kUndecided;
  return ExitStatus::kDone;
}

}  // namespace

void PortraitCommand::add_to(CLI::App& command) {
  command.add_option("FILE", file, "a request (PlanMotionRequest as JSON, see scenarios/); - is stdin")->required();
  command.add_option("--arm", arm, "name of the arm that is drawn, for its task in FILE")->required();
  command.add_flag("--json", json, "print the answer (GetPhasePortraitResponse) as JSON and nothing else");
  command.add_option("--svg", svg, "draw the phase plane into this file");
  command.add_option("--resolution", resolution, "points a curve, 2 to 10000 (361 where it is not given)");
  add_connection_options(command, connection);
  command.footer(
      "Exit status: 0 a motion, 2 usage or invalid request, 3 infeasible, 4 undecided or no answer in time, 5 server "
      "not reachable.");
}

ExitStatus PortraitCommand::run(const Interruption& interruption) const {
  const GetPhasePortraitRequest request = request_from(file, arm, resolution);
  const PlanningClient client(connection, interruption.token());
  const GetPhasePortraitResponse response = client.phase_portrait(request);
  const std::string name = name_of_file(file);
  print(json ? json_of(response) : portrait_report(name, arm, response) + "\n");
  if (!svg.empty()) write_text(svg, portrait_svg(name, request.task(), response));
  return exit_status_of(response);
}

}  // namespace dualarm

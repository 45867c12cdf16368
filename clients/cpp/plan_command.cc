#include "clients/cpp/plan_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/plan_report.h"
#include "clients/cpp/plan_svg.h"
#include "clients/cpp/plan_table.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/progress_report.h"
#include "clients/cpp/standard_output.h"

namespace dualarm {
namespace {

using namespace planning::v1;

// The error with the name of its file, which errors of reading have already.
std::string about(const std::string& file, const std::string& error) {
  const std::string prefix = shown_path(file) + ": ";
  return error.starts_with(prefix) ? error : prefix + error;
}

}  // namespace

void PlanCommand::add_to(CLI::App& command) {
  command.add_option("FILE", files, "requests (PlanMotionRequest as JSON, see scenarios/); - is stdin")->required();
  auto* json_flag = command.add_flag("--json", json, "print the answer as JSON and nothing else; one FILE");
  command.add_flag("--table", table, "print one row a FILE")->excludes(json_flag);
  command.add_flag("--progress", progress, "tell on stderr how far planning has come, and of each better plan");
  command.add_option("--output", output,
                     "also write the answer (PlanMotionResponse as JSON, what --json prints) to this file, for "
                     "'dualarm verify FILE --plan'; one FILE");
  command.add_option("--svg", svg, "draw the plan in the plane of the joint positions into this file; one FILE");
  command.add_option("--svg-folder", svg_folder, "draw every plan into this folder, as <name of FILE>.svg")
      ->check(CLI::ExistingDirectory);
  add_connection_options(command, connection);
  command.footer(
      "Exit status, the worst of all FILEs: 0 plan, 2 usage or invalid request, 3 infeasible, 4 undecided or "
      "no answer in time, 5 server not reachable.");
  command.callback([this] {
    if (files.size() > 1 && (json || !output.empty() || !svg.empty())) {
      throw CLI::ValidationError("--json, --output and --svg", "take exactly one FILE");
    }
  });
}

ExitStatus PlanCommand::run(const Interruption& interruption) const {
  const PlanningClient client(connection, interruption.token());
  if (table) print(table_header());
  ExitStatus worst = ExitStatus::kDone;
  for (const std::string& file : files) {
    try {
      worst = std::max(worst, plan_one(client, file));
    } catch (const CommandError& error) {
      if (files.size() == 1 || error.status() == ExitStatus::kInterrupted || !std::cout) throw;
      worst = std::max(worst, error.status());
      if (table) {
        print(table_row(name_of_file(file), error.what()));
      } else {
        std::cerr << "dualarm: " << about(file, error.what()) << std::endl;
      }
    }
  }
  return worst;
}

ExitStatus PlanCommand::plan_one(const PlanningClient& client, const std::string& file) const {
  PlanMotionRequest request;
  read_json(file, request);
  const PlanMotionResponse response =
      progress ? client.plan(request, [](const auto& event) { std::cerr << progress_line(event) << std::flush; })
               : client.plan(request);
  if (!output.empty()) write_text(output, json_of(response));
  if (json) {
    print(json_of(response));
  } else if (table) {
    print(table_row(name_of_file(file), response));
  } else {
    print(plan_report(name_of_file(file), response) + "\n");
  }
  draw(client, file, request, response);
  return exit_status_of(response);
}

void PlanCommand::draw(const PlanningClient& client, const std::string& file, const PlanMotionRequest& request,
                       const PlanMotionResponse& response) const {
  if (svg.empty() && svg_folder.empty()) return;
  const std::string drawing =
      plan_svg(name_of_file(file), request, response, client.forbidden_region(region_request_for(request)));
  if (!svg.empty()) write_text(svg, drawing);
  if (!svg_folder.empty()) {
    write_text((std::filesystem::path(svg_folder) / (name_of_file(file) + ".svg")).string(), drawing);
  }
}

}  // namespace dualarm

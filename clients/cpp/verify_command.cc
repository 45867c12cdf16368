#include "clients/cpp/verify_command.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/verification_report.h"

namespace dualarm {
namespace {

using namespace planning::v1;

// The scenario's demands put to the plan's trajectories.
VerifyMotionRequest request_from(const std::string& scenario_file, const std::string& plan_file) {
  PlanMotionRequest scenario;
  PlanMotionResponse answer;
  read_json(scenario_file, scenario);
  read_json(plan_file, answer);
  if (!answer.has_plan()) throw CommandError(ExitStatus::kInvalid, plan_file + ": holds no plan");
  VerifyMotionRequest request;
  *request.mutable_robot() = scenario.robot();
  if (scenario.has_scene()) *request.mutable_scene() = scenario.scene();
  *request.mutable_tasks() = scenario.tasks();
  request.set_clearance_m(scenario.options().clearance_m());
  *request.mutable_trajectories() = answer.plan().trajectories();
  return request;
}

VerifyMotionRequest request_from(const std::string& file) {
  VerifyMotionRequest request;
  read_json(file, request);
  return request;
}

}  // namespace

void VerifyCommand::add_to(CLI::App& command) {
  command
      .add_option("FILE", file,
                  "with --plan a scenario (PlanMotionRequest as JSON), without it a whole VerifyMotionRequest as JSON; "
                  "- is stdin")
      ->required();
  command.add_option("--plan", plan, "answer of 'dualarm plan --output' or '--json' whose motion is to be verified");
  command.add_flag("--json", json, "print the answer as JSON and nothing else");
  add_connection_options(command, connection);
  command.footer(
      "Exit status: 0 verified, 2 usage or invalid request, 3 a demand is broken or not proven, 4 no answer "
      "in time, 5 server not reachable.");
}

ExitStatus VerifyCommand::run(const Interruption& interruption) const {
  const VerifyMotionRequest request = plan.empty() ? request_from(file) : request_from(file, plan);
  const PlanningClient client(connection, interruption.token());
  const VerifyMotionResponse response = client.verify(request);
  const bool verified = is_verified(response.verification());
  if (json) {
    std::cout << json_of(response) << std::flush;
  } else {
    std::cout << (verified ? "verified: every demand is kept at every instant\n\n" : "NOT verified\n\n")
              << verification_lines(response.verification()) << std::flush;
  }
  return verified ? ExitStatus::kDone : ExitStatus::kNegative;
}

}  // namespace dualarm

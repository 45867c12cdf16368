#include "clients/cpp/verify_command.h"

#include <CLI/CLI.hpp>

#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/standard_output.h"
#include "clients/cpp/verification_report.h"

namespace dualarm {
namespace {

using namespace planning::v1;

// The plan in `file`: in a whole PlanMotionResponse, or a Plan by itself.
Plan read_plan(const std::string& file) {
  const std::string text = read_text(file);
  Plan plan;
  if (is_json_of(text, plan) && plan.trajectories_size() > 0) return plan;
  PlanMotionResponse answer;
  parse_json(file, text, answer);
  if (!answer.has_plan()) throw CommandError(ExitStatus::kInvalid, shown_path(file) + ": holds no plan");
  return answer.plan();
}

// The scenario's demands put to the plan's trajectories.
VerifyMotionRequest request_from(const std::string& scenario_file, const std::string& plan_file) {
  PlanMotionRequest scenario;
  read_json(scenario_file, scenario);
  const Plan plan = read_plan(plan_file);
  VerifyMotionRequest request;
  *request.mutable_robot() = scenario.robot();
  if (scenario.has_scene()) *request.mutable_scene() = scenario.scene();
  *request.mutable_tasks() = scenario.tasks();
  request.set_clearance_m(scenario.options().clearance_m());
  *request.mutable_trajectories() = plan.trajectories();
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
  command.add_option("--plan", plan,
                     "the motion to be verified: the answer that 'dualarm plan FILE --output' or '--json' wrote, or "
                     "the Plan in it by itself; - is stdin");
  command.add_flag("--json", json, "print the answer as JSON and nothing else");
  add_connection_options(command, connection);
  command.footer(
      "Plan, then verify: dualarm plan FILE --output plan.json && dualarm verify FILE --plan plan.json\n\n"
      "Exit status: 0 verified, 2 usage or invalid request, 3 a demand is broken or not proven, 4 no answer "
      "in time, 5 server not reachable.");
  command.callback([this] {
    if (file == "-" && plan == "-") throw CLI::ValidationError("FILE and --plan", "cannot both be stdin");
  });
}

ExitStatus VerifyCommand::run(const Interruption& interruption) const {
  const VerifyMotionRequest request = plan.empty() ? request_from(file) : request_from(file, plan);
  const PlanningClient client(connection, interruption.token());
  const VerifyMotionResponse response = client.verify(request);
  const bool verified = is_verified(response.verification());
  if (json) {
    print(json_of(response));
  } else {
    const std::string headline = verified ? "verified: every demand is kept at every instant" : "NOT verified";
    print(headline + "\n\n" + verification_lines(response.verification()));
  }
  return verified ? ExitStatus::kDone : ExitStatus::kNegative;
}

}  // namespace dualarm

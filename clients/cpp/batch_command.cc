#include "clients/cpp/batch_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <mutex>

#include "clients/cpp/batch_requests.h"
#include "clients/cpp/interruption.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/plan_table.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/standard_output.h"

namespace dualarm {
namespace {

using namespace planning::v1;

constexpr double kLongestBatch = 86400.0;  // s

// As the server would have answered it.
PlanMotionBatchResponse refusal_of(const UnreadableRequest& request) {
  PlanMotionBatchResponse answer;
  answer.set_request_id(request.request_id);
  answer.mutable_error()->set_code(grpc::StatusCode::INVALID_ARGUMENT);
  answer.mutable_error()->set_message(request.error);
  return answer;
}

grpc::Status status_of(const google::rpc::Status& error) {
  return {static_cast<grpc::StatusCode>(error.code()), error.message()};
}

}  // namespace

void BatchCommand::add_to(CLI::App& command) {
  command
      .add_option(
          "FILE", sources,
          "requests (PlanMotionRequest as JSON): files of one each, folders of such *.json, or - for stdin with "
          "one a line")
      ->required();
  command.add_flag("--json", json, "print each answer (PlanMotionBatchResponse) as one line of JSON and nothing else");
  connection.timeout_s = kLongestBatch;
  add_connection_options(command, connection, "seconds to wait for the whole batch");
  command.footer(
      "Answers come as they finish. Exit status, the worst of all: 0 plan, 2 usage or invalid request, 3 infeasible, 4 "
      "undecided, 5 server not reachable.");
}

ExitStatus BatchCommand::run(const Interruption& interruption) const {
  BatchRequests requests(sources);
  const PlanningClient client(connection, interruption.token());
  if (!json) print(table_header());
  std::mutex mutex;  // requests are read on one thread and answers come on another
  ExitStatus worst = ExitStatus::kDone;
  const auto show_next = [&](const PlanMotionBatchResponse& answer) {
    const std::lock_guard lock(mutex);
    worst = std::max(worst, show(answer, client.server_name()));
  };
  const auto next = [&]() -> std::optional<PlanMotionBatchRequest> {
    while (auto request = requests.next()) {
      if (auto* readable = std::get_if<PlanMotionBatchRequest>(&*request)) return std::move(*readable);
      show_next(refusal_of(std::get<UnreadableRequest>(*request)));
    }
    return std::nullopt;
  };
  client.plan_batch(next, show_next);
  return worst;
}

ExitStatus BatchCommand::show(const PlanMotionBatchResponse& answer, const std::string& server) const {
  if (json) print(json_line_of(answer));
  if (answer.has_response()) {
    if (!json) print(table_row(answer.request_id(), answer.response()));
    return exit_status_of(answer.response());
  }
  if (!json) print(table_row(answer.request_id(), answer.error().message()));
  return error_of_call(status_of(answer.error()), server).status();
}

}  // namespace dualarm

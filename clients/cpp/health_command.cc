#include "clients/cpp/health_command.h"

#include <CLI/CLI.hpp>

#include "clients/cpp/interruption.h"
#include "clients/cpp/planning_client.h"
#include "clients/cpp/standard_output.h"

namespace dualarm {

void HealthCommand::add_to(CLI::App& command) {
  command.add_option("--service", service, "full name of the service to ask about; empty: the server as a whole")
      ->capture_default_str();
  add_connection_options(command, connection);
  command.footer("Exit status: 0 serving, 2 usage, 5 not serving, unknown service, or not reachable.");
}

ExitStatus HealthCommand::run(const Interruption& interruption) const {
  PlanningClient client(connection, interruption.token());
  const bool serving = client.is_serving(service);
  print(client.server_name() + (serving ? " is serving\n" : " is not serving\n"));
  return serving ? ExitStatus::kDone : ExitStatus::kUnreachable;
}

}  // namespace dualarm

// dualarm: plan and verify motions of two arms from the command line.
#include <CLI/CLI.hpp>
#include <iostream>

#include "clients/cpp/batch_command.h"
#include "clients/cpp/health_command.h"
#include "clients/cpp/interruption.h"
#include "clients/cpp/plan_command.h"
#include "clients/cpp/portrait_command.h"
#include "clients/cpp/region_command.h"
#include "clients/cpp/standard_output.h"
#include "clients/cpp/verify_command.h"

namespace dualarm {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Time-optimal, verified motions for two arms that share a workspace.", "dualarm");
  app.set_version_flag("--version", "dualarm " DUALARM_VERSION);
  app.require_subcommand(1);
  PlanCommand plan;
  BatchCommand batch;
  VerifyCommand verify;
  PortraitCommand portrait;
  RegionCommand region;
  HealthCommand health;
  CLI::App* plan_app = app.add_subcommand("plan", "plan the fastest verified motion of a request");
  CLI::App* batch_app = app.add_subcommand("batch", "plan many requests through one stream");
  CLI::App* verify_app = app.add_subcommand("verify", "verify a motion at every instant");
  CLI::App* portrait_app = app.add_subcommand("portrait", "draw the phase plane of one arm and its fastest motion");
  CLI::App* region_app = app.add_subcommand("region", "draw the joint positions at which the two arms collide");
  CLI::App* health_app = app.add_subcommand("health", "ask whether a server is serving");
  plan.add_to(*plan_app);
  batch.add_to(*batch_app);
  verify.add_to(*verify_app);
  portrait.add_to(*portrait_app);
  region.add_to(*region_app);
  health.add_to(*health_app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_answer = app.exit(error) == 0;  // help or version
    print("");
    return static_cast<int>(is_answer ? ExitStatus::kDone : ExitStatus::kInvalid);
  }
  const Interruption interruption;
  if (plan_app->parsed()) return static_cast<int>(plan.run(interruption));
  if (batch_app->parsed()) return static_cast<int>(batch.run(interruption));
  if (verify_app->parsed()) return static_cast<int>(verify.run(interruption));
  if (portrait_app->parsed()) return static_cast<int>(portrait.run(interruption));
  if (region_app->parsed()) return static_cast<int>(region.run(interruption));
  return static_cast<int>(health.run(interruption));
}

}  // namespace
}  // namespace dualarm

int main(int argc, char** argv) {
  try {
    return dualarm::run(argc, argv);
  } catch (const dualarm::CommandError& error) {
    std::cerr << "dualarm: " << error.what() << std::endl;
    return static_cast<int>(error.status());
  } catch (const std::exception& error) {
    std::cerr << "dualarm: " << error.what() << std::endl;
    return static_cast<int>(dualarm::ExitStatus::kFailure);
  }
}

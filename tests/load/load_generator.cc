// load_generator: what the service does under load. docs/performance.md has the commands and what they showed.
#include <CLI/CLI.hpp>
#include <string>

#include "tests/load/comparison.h"
#include "tests/load/many.h"
#include "tests/load/mixed.h"
#include "tests/load/overload.h"
#include "tests/load/stopping.h"

int main(int argc, char** argv) {
  CLI::App app("Puts load on a dualarm server, which it starts itself", "load_generator");
  app.require_subcommand(1);
  std::string scenario = "paper_case1";
  double seconds = 10.0;
  int callers = 32;
  int searches = 64;
  int count = 1000;
  unsigned seed = 1;
  const auto add = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("--seconds", seconds, "how long")->capture_default_str();
    return command;
  };
  auto* compare = add("compare", "PlanMotion against an empty call with a reply of the same size");
  compare->add_option("--scenario", scenario, "what is planned")->capture_default_str();
  compare->add_option("--callers", callers, "at once")->capture_default_str();
  auto* overload = add("overload", "fast plans while searches fill their queue");
  overload->add_option("--searches", searches, "at once")->capture_default_str();
  auto* streams = app.add_subcommand("streams", "many streams at once");
  streams->add_option("--count", count, "at once")->capture_default_str();
  auto* batch = app.add_subcommand("batch", "many requests through one batch");
  batch->add_option("--count", count, "in all")->capture_default_str();
  auto* slow = add("slow-reader", "a client that never reads");
  auto* mixed = add("mixed", "everything at once");
  mixed->add_option("--seed", seed, "of what comes when")->capture_default_str();
  auto* stopping = app.add_subcommand("stopping", "how long planning goes on when its caller has left");
  stopping->add_option("--count", count, "moments for each scenario")->capture_default_str();
  stopping->add_option("--seed", seed, "of the moments")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if (compare->parsed()) return dualarm::compare_with_empty_call(scenario, seconds, callers);
  if (overload->parsed()) return dualarm::measure_overload(seconds, searches);
  if (streams->parsed()) return dualarm::open_many_streams(count);
  if (batch->parsed()) return dualarm::plan_one_batch(count);
  if (slow->parsed()) return dualarm::refuse_to_read(seconds);
  if (mixed->parsed()) return dualarm::run_mixed_load(seconds, seed);
  if (stopping->parsed()) return dualarm::measure_stopping(count, seed);
  return 1;
}

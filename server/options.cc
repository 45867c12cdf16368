#include "server/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include "server/build_information.h"
#include "server/listen_address.h"
#include "server/metrics/metrics_endpoint.h"

namespace dualarm {
namespace {

/// CLI::Range, to which what is no number lies inside.
CLI::Validator range(double lower, double upper) {
  const CLI::Range inside(lower, upper);
  const auto complain = [inside](std::string& text) {
    double value = 0.0;
    if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
      return "Value " + text + " is no number: give one " + inside.get_description();
    return inside(text);
  };
  return {complain, inside.get_description()};
}

/// A pipe would keep the server waiting for somebody to write into it, and a device may have no end.
std::string complaint_about_configuration(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return "";
  return path + " is no regular file: name a TOML file";
}

void add_request_limits(CLI::App& app, RequestLimits& limits) {
  const auto add = [&app](const char* flag, int& limit, const char* what) {
    app.add_option(flag, limit, what)->check(CLI::Range(1, 10'000'000));
  };
  add("--max-objects", limits.objects, "Objects of a scene");
  add("--max-poses", limits.poses, "Poses of an object's track");
  add("--max-knots", limits.knots, "Knots, and arcs, of a trajectory that is to be verified");
  add("--max-table-lines", limits.table_lines, "Positions or velocities of a torque table");
  add("--max-table-entries", limits.table_entries, "Entries of a torque table");
}

void add_options(CLI::App& app, ServerOptions& options) {
  app.add_option("--listen", options.listen, "HOST:PORT (port 0: any free one) or unix:PATH")
      ->check(CLI::Validator(complaint_about_address, ""));
  app.add_option("--port-file", options.port_file, "Write the bound port to this file");
  app.add_flag("--allow-insecure-remote", options.allow_insecure_remote,
               "Serve plaintext on addresses other than loopback and unix sockets");
  app.add_option("--max-message-mib", options.max_message_mib, "Largest request in MiB")->check(CLI::Range(1, 1024));
  app.add_option("--worker-threads", options.worker_threads, "Quick computations at once")->check(CLI::Range(1, 1024));
  app.add_option("--queue-capacity", options.queue_capacity, "Requests that may wait for a worker")
      ->check(CLI::Range(0, 1'000'000));
  app.add_option("--inline-milliseconds", options.inline_milliseconds,
                 "Processor time for which gRPC's own thread may try a plan before a worker takes it over: 0 none")
      ->check(range(0.0, 100.0));
  app.add_option("--search-threads", options.search_threads, "Searches at once")->check(CLI::Range(1, 1024));
  app.add_option("--search-queue", options.search_queue, "Requests that may wait for a search")
      ->check(CLI::Range(0, 1'000'000));
  app.add_option("--niceness", options.niceness,
                 "How far threads that search or draw stand back behind quick ones: 0 not at all")
      ->check(CLI::Range(0, 19));
  app.add_option("--max-streams", options.max_streams, "Calls of PlanMotionStream and PlanMotionBatch at once")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--batch-in-flight", options.batch_in_flight, "Requests of one batch that are read and not answered")
      ->check(CLI::Range(1, 10'000));
  app.add_option("--search-memory-mib", options.search_memory_mib, "What one search may take in MiB")
      ->check(CLI::Range(1, 65536));
  add_request_limits(app, options.request);
  app.add_option("--planning-budget", options.planning_budget, "Longest computation of one request in seconds")
      ->check(range(1e-3, 1e6));
  app.add_option("--drain-seconds", options.drain_seconds,
                 "What running calls get to finish after SIGTERM or SIGINT, in seconds")
      ->check(range(0.0, 3600.0));
  app.add_option("--log-level", options.log_level, "How much is logged to stderr")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "critical", "off"}));
}

std::string complaint_about_metrics_address(const std::string& listen) {
  return listen.empty() ? "" : complaint_about_address(metrics_address(listen));
}

void add_operations_options(CLI::App& app, ServerOptions& options) {
  app.add_option("--drain-notice", options.drain_notice,
                 "How long the server still serves after SIGTERM while health says NOT_SERVING, in seconds")
      ->check(range(0.0, 3600.0));
  app.add_option("--log-format", options.log_format, "How a line of the log looks")
      ->check(CLI::IsMember({"text", "json"}));
  app.add_option("--metrics-listen", options.metrics_listen,
                 "HOST:PORT, or PORT on 127.0.0.1, of Prometheus metrics at /metrics (port 0: any free one)")
      ->check(CLI::Validator(complaint_about_metrics_address, ""));
  app.add_option("--replay-dir", options.replay_dir, "Folder that keeps requests that met a bug, as scenario files");
  app.add_option("--replay-limit", options.replay_limit, "Files in that folder; more are not kept")
      ->check(CLI::Range(1, 100'000));
}

void add_security_options(CLI::App& app, ServerOptions& options) {
  auto* cert = app.add_option("--tls-cert", options.tls_cert, "PEM file with the server's certificate chain: TLS");
  auto* key = app.add_option("--tls-key", options.tls_key, "PEM file with its private key");
  cert->needs(key);
  key->needs(cert);
  app.add_option("--tls-client-ca", options.tls_client_ca,
                 "PEM file with the authorities whose certificates clients must present: mutual TLS")
      ->needs(cert);
  app.add_option("--token-file", options.token_file, "File with the tokens of callers; without it anybody may call");
  app.add_option("--token-concurrency", options.token_concurrency, "Calls at once of one token")
      ->check(CLI::Range(1, 1'000'000));
}

// DUALARM_ and the flag's name in capitals with underscores, for all that can be configured.
void name_environment(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (!option->get_configurable()) continue;
    std::string name = "DUALARM_" + option->get_single_name();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return c == '-' ? '_' : static_cast<char>(std::toupper(c)); });
    option->envname(name);
  }
}

// CLI11 lets the file win over the environment: what the environment gives is left out of the file.
class FileBelowEnvironment final : public CLI::ConfigTOML {
 public:
  explicit FileBelowEnvironment(const CLI::App& app) : app_(app) {}

  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override {
    std::vector<CLI::ConfigItem> given = CLI::ConfigTOML::from_config(input);
    std::erase_if(given, [this](const CLI::ConfigItem& item) { return is_in_environment(item); });
    return given;
  }

 private:
  bool is_in_environment(const CLI::ConfigItem& item) const {
    const CLI::Option* option = app_.get_option_no_throw("--" + item.name);
    const char* value = option == nullptr ? nullptr : std::getenv(option->get_envname().c_str());
    return item.parents.empty() && value != nullptr && *value != '\0';
  }

  const CLI::App& app_;
};

void add_configuration_file(CLI::App& app, ServerOptions& options) {
  const char* file = std::getenv("DUALARM_CONFIG");
  const std::string from_environment = file == nullptr ? "" : file;
  app.set_config("--config", from_environment, "TOML file with any of these options: listen = \"127.0.0.1:50051\"",
                 !from_environment.empty())
      ->check(CLI::Validator(complaint_about_configuration, ""))
      ->envname("DUALARM_CONFIG");
  app.config_formatter(std::make_shared<FileBelowEnvironment>(app));
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.add_flag("--check-config", options.check_config,
               "Print the options in force, look at the files they name, and end: status 0 if all is well, else 2")
      ->configurable(false);
}

void add_all(CLI::App& app, ServerOptions& options) {
  app.set_version_flag("--version", version_line());
  app.option_defaults()->always_capture_default();
  add_options(app, options);
  add_operations_options(app, options);
  add_security_options(app, options);
  name_environment(app);
  add_configuration_file(app, options);
  app.add_flag_callback(
      "--options-table",
      [] {
        std::cout << options_table();
        throw CLI::Success();
      },
      "Print the options as a table in Markdown, that of docs/operations.md");
}

// "INT in [1 - 1024]" is "1 to 1024", "{text,json}" is "text, json".
std::string range_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find_first_of("[{");
  const std::size_t close = type.find_last_of("]}");
  if (open == std::string::npos || close == std::string::npos) return "";
  std::string range = type.substr(open + 1, close - open - 1);
  if (const std::size_t dash = range.find(" - "); dash != std::string::npos) return range.replace(dash, 3, " to ");
  for (std::size_t comma = range.find(','); comma != std::string::npos; comma = range.find(',', comma + 2)) {
    range.replace(comma, 1, ", ");
  }
  return range;
}

// The number of threads is this machine's.
std::string default_of(const CLI::Option& option) {
  if (option.get_name().ends_with("-threads")) return "hardware threads";
  const bool is_flag = option.get_items_expected_max() == 0;
  return option.get_default_str().empty() ? (is_flag ? "false" : "none") : option.get_default_str();
}

// The options in force, as a configuration file has them.
std::string listing_of(const CLI::App& app) {
  std::string listing;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_envname().empty()) continue;  // help, version, check-config
    const std::string value = option->count() > 0 ? option->as<std::string>() : option->get_default_str();
    const bool bare =
        value.find_first_not_of("0123456789.e+-") == std::string::npos || value == "true" || value == "false";
    if (value.empty()) continue;
    listing += fmt::format("{} = {}\n", option->get_single_name(), bare ? value : fmt::format("\"{}\"", value));
  }
  return listing;
}

}  // namespace

std::string options_table() {
  ServerOptions options;
  CLI::App app;
  add_all(app, options);
  std::string table = "| flag | environment | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_envname().empty()) continue;  // help, version, check-config
    table += fmt::format("| `{}` | `{}` | {} | {} | {} |\n", option->get_name(), option->get_envname(),
                         default_of(*option), range_of(*option), option->get_description());
  }
  return table;
}

std::variant<ServerOptions, ExitStatus> read_options(int argc, const char* const* argv) {
  ServerOptions options;
  options.worker_threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  options.search_threads = options.worker_threads;
  CLI::App app("Plans time-optimal, verified motions of two arms over gRPC", "dualarm-server");
  add_all(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ConfigError& error) {
    std::cerr << "the file given by --config: " << error.what()
              << "\nIts keys are options without their dashes, such as listen = \"127.0.0.1:50051\"; see --help.\n";
    return ExitStatus{kUsageError};
  } catch (const CLI::ParseError& error) {
    return ExitStatus{app.exit(error) == 0 ? 0 : kUsageError};
  }
  if (options.check_config) std::cout << listing_of(app);
  return options;
}

}  // namespace dualarm

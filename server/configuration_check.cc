#include "server/configuration_check.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "server/listen_address.h"
#include "server/logging/replay_folder.h"
#include "server/metrics/metrics_endpoint.h"
#include "server/security/security.h"

namespace dualarm {
namespace {

std::vector<std::string> about_exposure(const ServerOptions& options) {
  if (!options.tls_cert.empty() || is_local_address(options.listen)) return {};
  if (!options.token_file.empty()) {
    return {
        fmt::format("tokens on {} could be read by others on the way: give --tls-cert and --tls-key, or listen on "
                    "127.0.0.1",
                    options.listen)};
  }
  if (options.allow_insecure_remote) return {};
  return {
      fmt::format("{} can be reached from other machines, and without --tls-cert this server speaks plaintext: "
                  "listen on 127.0.0.1, or say --allow-insecure-remote where something else protects it",
                  options.listen)};
}

std::string complaint_about_port_file(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  std::error_code error;
  if (std::filesystem::is_directory(folder, error)) return "";
  return fmt::format("--port-file {} would be in a folder that does not exist: make {}", path, folder.string());
}

/// Port 0 is another one each time.
bool share_an_address(const ServerOptions& options) {
  return !options.metrics_listen.empty() && !options.listen.ends_with(":0") &&
         metrics_address(options.metrics_listen) == options.listen;
}

}  // namespace

std::vector<std::string> complaints_about(const ServerOptions& options) {
  std::vector<std::string> complaints;
  const std::string about_address = complaint_about_address(options.listen);
  if (about_address.empty()) {
    complaints = about_exposure(options);
  } else {
    complaints.push_back(about_address);
  }
  try {
    const Security security(options);
  } catch (const std::runtime_error& error) {
    complaints.push_back(error.what());
  }
  const auto add = [&complaints](std::string complaint) {
    if (!complaint.empty()) complaints.push_back(std::move(complaint));
  };
  if (!options.replay_dir.empty()) add(complaint_about_folder(options.replay_dir));
  if (!options.port_file.empty()) add(complaint_about_port_file(options.port_file));
  if (share_an_address(options)) {
    complaints.push_back(
        fmt::format("--listen and --metrics-listen are both {}: give one of them another port", options.listen));
  }
  return complaints;
}

}  // namespace dualarm

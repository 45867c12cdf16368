#include "clients/cpp/connection_options.h"

#include <CLI/CLI.hpp>

namespace dualarm {

void add_connection_options(CLI::App& command, ConnectionOptions& options, const std::string& timeout) {
  auto* server =
      command.add_option("--server", options.server,
                         "HOST:PORT of a dualarm-server; without it the server beside this program is started on a "
                         "private socket and stopped afterwards");
  server->check(CLI::Validator(
      [](const std::string& text) { return text.empty() ? "is empty: give HOST:PORT or unix:PATH" : ""; }, ""));
  command.add_option("--timeout", options.timeout_s, timeout)->check(CLI::Range(1e-3, 86400.0))->capture_default_str();
  auto* ca = command.add_option("--tls-ca", options.tls_ca,
                                "PEM file with the authorities that sign the server's certificate: TLS");
  auto* cert = command.add_option("--tls-cert", options.tls_cert, "PEM file with this client's own certificate chain");
  auto* key = command.add_option("--tls-key", options.tls_key, "PEM file with its private key");
  auto* token = command.add_option("--token-file", options.token_file,
                                   "file with the token that the server asks for; sent over TLS or to this machine");
  ca->needs(server);
  token->needs(server);
  cert->needs(ca)->needs(key);
  key->needs(cert);
}

}  // namespace dualarm

// Where the server is, how to reach it, and how long to wait for it: the options that every command shares.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace dualarm {

struct ConnectionOptions {
  std::string server;       ///< HOST:PORT, or unix:PATH; empty: start the server beside this program
  double timeout_s = 60.0;  ///< for one call
  std::string tls_ca;       ///< PEM file, who signs the server's certificate; empty: plaintext
  std::string tls_cert;     ///< PEM file, the client's own certificate chain; empty: none
  std::string tls_key;      ///< PEM file, its private key
  std::string token_file;   ///< file that holds the token to be sent; empty: none
};

/// `timeout`: what --timeout is said to mean.
void add_connection_options(CLI::App& command, ConnectionOptions& options,
                            const std::string& timeout = "seconds to wait for one answer");

}  // namespace dualarm

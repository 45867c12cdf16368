#pragma once

#include <memory>
#include <string>

#include "server/metrics/metrics.h"

namespace prometheus {
class Exposer;
}

namespace dualarm {

/// Serves GET /metrics, and nothing else, over plain HTTP on a port of its own.
class MetricsEndpoint {
 public:
  /// `listen`: HOST:PORT, or PORT alone for 127.0.0.1; port 0 takes any free one. Throws std::runtime_error, with a
  /// message for the operator, where it cannot listen there.
  MetricsEndpoint(const std::string& listen, const Metrics& metrics);
  ~MetricsEndpoint();

  /// Where it listens: HOST:PORT.
  const std::string& address() const { return address_; }

 private:
  std::unique_ptr<prometheus::Exposer> exposer_;
  std::string address_;
};

/// "HOST:PORT" of "HOST:PORT" or "PORT".
std::string metrics_address(const std::string& listen);

}  // namespace dualarm

#include "server/metrics/metrics_endpoint.h"

#include <fmt/format.h>
#include <prometheus/exposer.h>

#include <stdexcept>
#include <vector>

#include "server/listen_address.h"

namespace dualarm {
namespace {

constexpr char kLoopback[] = "127.0.0.1:";
constexpr char kThreads[] = "16";             // one answers while others wait for slow readers and half requests
constexpr char kRequestTimeoutMs[] = "1000";  // then a silent connection gives its thread back

}  // namespace

std::string metrics_address(const std::string& listen) {
  return listen.find_first_not_of("0123456789") == std::string::npos ? kLoopback + listen : listen;
}

MetricsEndpoint::MetricsEndpoint(const std::string& listen, const Metrics& metrics) {
  const std::string address = metrics_address(listen);
  try {
    exposer_ = std::make_unique<prometheus::Exposer>(std::vector<std::string>{
        "listening_ports", address, "num_threads", kThreads, "request_timeout_ms", kRequestTimeoutMs});
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("cannot serve metrics on {}: {}", address, error.what()));
  }
  for (const auto& collectable : metrics.collectables()) exposer_->RegisterCollectable(collectable);
  address_ = bound_address(address, exposer_->GetListeningPorts().at(0));
}

MetricsEndpoint::~MetricsEndpoint() = default;

}  // namespace dualarm

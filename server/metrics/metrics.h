#pragma once

#include <grpcpp/support/status_code_enum.h>
#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/logging/answer_notes.h"

namespace dualarm {

/// What Prometheus is told; docs/operations.md has the table. From any thread.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// A call began; `method` is its full path, "/package.Service/Method".
  void begin_call(std::string_view method);

  /// It ended.
  void end_call(std::string_view method, grpc::StatusCode code, std::chrono::duration<double> duration);

  /// One plan was answered: outcome, method, gap, phases.
  void count(const PlanFigures& figures);

  /// One call of PlanMotion: what it took besides planning, which is waiting for a worker, parsing and encoding.
  void count_rest(std::chrono::duration<double> rest);

  /// Certificates and tokens were read anew, or were kept because the new ones are no good.
  void count_reload(bool good);

  /// Reads a value whenever Prometheus asks. `read` must stay valid as long as this object.
  void watch(const std::string& name, const std::string& help, const std::map<std::string, std::string>& labels,
             std::function<double()> read);

  /// All of it, for a prometheus::Exposer, which holds them weakly.
  std::vector<std::weak_ptr<prometheus::Collectable>> collectables() const;

  /// All of it in Prometheus's text format.
  std::string text() const;

 private:
  class Watched;
  struct Method;

  Method& method(std::string_view path);

  std::shared_ptr<prometheus::Registry> registry_;  // shared: prometheus-cpp wants it so
  std::shared_ptr<Watched> watched_;                // the same
  prometheus::Family<prometheus::Counter>& handled_;
  std::map<std::string, std::unique_ptr<Method>, std::less<>> methods_;  // fixed by the constructor
  std::unique_ptr<Method> other_methods_;
  std::map<std::string, prometheus::Counter*, std::less<>> answers_;  // by outcome
  std::map<wire::Method, prometheus::Counter*> plans_;                // by the method that found them
  prometheus::Counter& searches_;
  prometheus::Histogram& gap_;
  std::array<prometheus::Histogram*, 4> phases_;  // analytic, verification, search, rest
  prometheus::Family<prometheus::Counter>& reloads_;
};

}  // namespace dualarm

#include "server/metrics/metrics.h"

#include <prometheus/text_serializer.h>

#include <mutex>
#include <utility>

#include "server/logging/call_log.h"

namespace dualarm {
namespace {

using prometheus::Histogram;

// Seconds: around what a plan takes (1e-4 to 1e-2), up to the longest a call may.
const Histogram::BucketBoundaries& call_buckets() {
  static const Histogram::BucketBoundaries kBuckets = {0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1,
                                                       0.2,    0.5,   1.0,   2.0,   5.0,  10.0, 30.0};
  return kBuckets;
}
const Histogram::BucketBoundaries& phase_buckets() {
  static const Histogram::BucketBoundaries kBuckets = {0.00003, 0.0001, 0.0003, 0.001, 0.003, 0.01,
                                                       0.03,    0.1,    0.3,    1.0,   3.0,   10.0};
  return kBuckets;
}
const Histogram::BucketBoundaries& gap_buckets() {
  static const Histogram::BucketBoundaries kBuckets = {1e-9, 1e-6, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0};
  return kBuckets;
}

// Of PlanFigures.
constexpr std::array<const char*, 5> kOutcomes = {"plan", "infeasible", "undecided", "valid", "error"};
constexpr std::string_view kOtherService = "other";
constexpr std::string_view kOtherMethod = "other";

}  // namespace

// One RPC's instruments. The counter of OK is at hand; those of errors are looked up.
struct Metrics::Method {
  std::string service;
  std::string name;
  prometheus::Counter& ok;
  prometheus::Histogram& seconds;
  prometheus::Gauge& in_flight;
};

class Metrics::Watched final : public prometheus::Collectable {
 public:
  struct Value {
    std::string name, help;
    prometheus::Labels labels;
    std::function<double()> read;
  };

  void add(Value value) {
    const std::lock_guard lock(mutex_);
    values_.push_back(std::move(value));
  }

  std::vector<prometheus::MetricFamily> Collect() const override {
    const std::lock_guard lock(mutex_);
    std::map<std::string, prometheus::MetricFamily> families;
    for (const Value& value : values_) {
      auto& family = families[value.name];
      family.name = value.name;
      family.help = value.help;
      family.type = prometheus::MetricType::Gauge;
      prometheus::ClientMetric& metric = family.metric.emplace_back();
      for (const auto& [name, label] : value.labels) metric.label.push_back({name, label});
      metric.gauge.value = value.read();
    }
    std::vector<prometheus::MetricFamily> list;
    for (auto& [name, family] : families) list.push_back(std::move(family));
    return list;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Value> values_;
};

Metrics::Metrics()
    : registry_(std::make_shared<prometheus::Registry>()),
      watched_(std::make_shared<Watched>()),
      handled_(prometheus::BuildCounter()
                   .Name("grpc_server_handled_total")
                   .Help("Calls that ended, by status code")
                   .Register(*registry_)),
      searches_(prometheus::BuildCounter()
                    .Name("dualarm_searches_total")
                    .Help("Planning requests that needed the state-time search")
                    .Register(*registry_)
                    .Add({})),
      gap_(prometheus::BuildHistogram()
               .Name("dualarm_plan_gap")
               .Help("Duration of a plan over its proven lower bound, less 1")
               .Register(*registry_)
               .Add({}, gap_buckets())),
      reloads_(prometheus::BuildCounter()
                   .Name("dualarm_reloads_total")
                   .Help("Reloads of certificates and tokens; failed ones left the old in use")
                   .Register(*registry_)) {
  auto& seconds = prometheus::BuildHistogram()
                      .Name("grpc_server_handling_seconds")
                      .Help("From a call's first byte to its status")
                      .Register(*registry_);
  auto& in_flight =
      prometheus::BuildGauge().Name("dualarm_calls_in_flight").Help("Calls that run or wait").Register(*registry_);
  const auto instruments = [&](std::string_view service, std::string_view name) {
    const prometheus::Labels labels = {{"grpc_service", std::string(service)}, {"grpc_method", std::string(name)}};
    prometheus::Labels ok = labels;
    ok["grpc_code"] = "OK";
    return std::make_unique<Method>(Method{std::string(service), std::string(name), handled_.Add(ok),
                                           seconds.Add(labels, call_buckets()), in_flight.Add(labels)});
  };
  const auto* service = wire::PlanMotionRequest::descriptor()->file()->FindServiceByName("PlanningService");
  for (int i = 0; i < service->method_count(); ++i) {
    const std::string& name = service->method(i)->name();
    methods_["/" + service->full_name() + "/" + name] = instruments(service->full_name(), name);
  }
  methods_["/grpc.health.v1.Health/Check"] = instruments("grpc.health.v1.Health", "Check");
  methods_["/grpc.health.v1.Health/Watch"] = instruments("grpc.health.v1.Health", "Watch");
  other_methods_ = instruments(kOtherService, kOtherMethod);
  auto& answers = prometheus::BuildCounter()
                      .Name("dualarm_answers_total")
                      .Help("Answers to planning requests, each request of a batch for itself, by outcome")
                      .Register(*registry_);
  for (const char* outcome : kOutcomes) answers_[outcome] = &answers.Add({{"outcome", outcome}});
  auto& plans = prometheus::BuildCounter()
                    .Name("dualarm_plans_total")
                    .Help("Plans, by the method that found them")
                    .Register(*registry_);
  const auto* methods = wire::Method_descriptor();
  for (int i = 0; i < methods->value_count(); ++i) {
    const auto& value = *methods->value(i);
    if (value.number() == wire::METHOD_UNSPECIFIED) continue;
    plans_[static_cast<wire::Method>(value.number())] = &plans.Add({{"method", value.name()}});
  }
  auto& phases = prometheus::BuildHistogram()
                     .Name("dualarm_phase_seconds")
                     .Help("What a planning request took; rest is waiting for a worker, parsing and encoding")
                     .Register(*registry_);
  constexpr std::array<const char*, 4> kPhases = {"analytic", "verification", "search", "rest"};
  for (std::size_t i = 0; i < kPhases.size(); ++i) phases_[i] = &phases.Add({{"phase", kPhases[i]}}, phase_buckets());
}

Metrics::~Metrics() = default;

Metrics::Method& Metrics::method(std::string_view path) {
  const auto found = methods_.find(path);
  return found == methods_.end() ? *other_methods_ : *found->second;
}

void Metrics::begin_call(std::string_view path) { method(path).in_flight.Increment(); }

void Metrics::end_call(std::string_view path, grpc::StatusCode code, std::chrono::duration<double> duration) {
  Method& called = method(path);
  called.in_flight.Decrement();
  called.seconds.Observe(duration.count());
  if (code == grpc::StatusCode::OK) return called.ok.Increment();
  handled_
      .Add(
          {{"grpc_service", called.service}, {"grpc_method", called.name}, {"grpc_code", std::string(code_name(code))}})
      .Increment();
}

void Metrics::count(const PlanFigures& figures) {
  answers_.at(figures.outcome)->Increment();
  if (figures.method && plans_.contains(*figures.method)) plans_.at(*figures.method)->Increment();
  if (figures.gap) gap_.Observe(*figures.gap);
  if (figures.searched) searches_.Increment();
  if (figures.planning_seconds <= 0.0) return;
  phases_[0]->Observe(figures.analytic_seconds);
  phases_[1]->Observe(figures.verification_seconds);
  if (figures.searched) phases_[2]->Observe(figures.search_seconds);
}

void Metrics::count_rest(std::chrono::duration<double> rest) { phases_[3]->Observe(rest.count()); }

void Metrics::count_reload(bool good) { reloads_.Add({{"result", good ? "done" : "failed"}}).Increment(); }

void Metrics::watch(const std::string& name, const std::string& help, const std::map<std::string, std::string>& labels,
                    std::function<double()> read) {
  watched_->add({name, help, labels, std::move(read)});
}

std::vector<std::weak_ptr<prometheus::Collectable>> Metrics::collectables() const { return {registry_, watched_}; }

std::string Metrics::text() const {
  std::vector<prometheus::MetricFamily> all = registry_->Collect();
  for (auto& family : watched_->Collect()) all.push_back(std::move(family));
  return prometheus::TextSerializer().Serialize(all);
}

}  // namespace dualarm

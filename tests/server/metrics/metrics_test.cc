#include "server/metrics/metrics.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "server/metrics/metrics_endpoint.h"
#include "tests/server/http_get.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr char kPlanMotion[] = "/dualarm.planning.v1.PlanningService/PlanMotion";

TEST(Metrics, CountsCallsByMethodAndCode) {
  Metrics metrics;
  const std::string labels = "grpc_method=\"PlanMotion\",grpc_service=\"dualarm.planning.v1.PlanningService\"";
  metrics.begin_call(kPlanMotion);
  metrics.begin_call(kPlanMotion);
  EXPECT_THAT(metrics.text(), HasSubstr("dualarm_calls_in_flight{" + labels + "} 2"));
  metrics.end_call(kPlanMotion, grpc::StatusCode::OK, std::chrono::milliseconds(3));
  metrics.end_call(kPlanMotion, grpc::StatusCode::INTERNAL, std::chrono::milliseconds(3));
  metrics.begin_call("/any.Service/Any");
  metrics.end_call("/any.Service/Any", grpc::StatusCode::OK, std::chrono::milliseconds(1));
  const std::string text = metrics.text();
  EXPECT_THAT(text, HasSubstr("grpc_server_handled_total{grpc_code=\"OK\"," + labels + "} 1\n"));
  EXPECT_THAT(text, HasSubstr("grpc_server_handled_total{grpc_code=\"INTERNAL\"," + labels + "} 1\n"));
  EXPECT_THAT(text, HasSubstr("grpc_server_handling_seconds_bucket{" + labels + ",le=\"0.002\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("grpc_server_handling_seconds_bucket{" + labels + ",le=\"0.005\"} 2\n"));
  EXPECT_THAT(text, HasSubstr("dualarm_calls_in_flight{" + labels + "} 0"));
  EXPECT_THAT(text,
              HasSubstr("grpc_server_handled_total{grpc_code=\"OK\",grpc_method=\"other\",grpc_service=\"other\"} 1"));
}

TEST(Metrics, CountsOutcomesMethodsGapsSearchesAndPhases) {
  Metrics metrics;
  metrics.count({"plan", wire::METHOD_STATE_TIME, 0.2, true, 0.5, 0.0002, 0.02, 0.4});
  metrics.count({"plan", wire::METHOD_DELAY, 0.0, false, 0.5, 0.0002, 0.02, 0.0});
  metrics.count({"infeasible", {}, {}, false, 0.0, 0.0, 0.0, 0.0});
  metrics.count_rest(std::chrono::milliseconds(2));
  metrics.count_reload(false);
  const std::string text = metrics.text();
  for (const char* line :
       {"dualarm_answers_total{outcome=\"plan\"} 2", "dualarm_answers_total{outcome=\"infeasible\"} 1",
        "dualarm_plans_total{method=\"METHOD_STATE_TIME\"} 1", "dualarm_searches_total 1", "dualarm_plan_gap_count 2",
        "dualarm_plan_gap_bucket{le=\"1e-09\"} 1", "dualarm_plan_gap_bucket{le=\"0.3\"} 2",
        "dualarm_phase_seconds_bucket{phase=\"analytic\",le=\"0.0003\"} 2",
        "dualarm_phase_seconds_count{phase=\"search\"} 1", "dualarm_phase_seconds_count{phase=\"verification\"} 2",
        "dualarm_phase_seconds_count{phase=\"rest\"} 1", "dualarm_reloads_total{result=\"failed\"} 1"}) {
    EXPECT_THAT(text, HasSubstr(std::string(line) + "\n"));
  }
}

TEST(Metrics, ReadsWatchedValuesWhenAsked) {
  Metrics metrics;
  double depth = 1.0;
  metrics.watch("dualarm_pool_waiting", "Depth", {{"pool", "quick"}}, [&depth] { return depth; });
  depth = 7.0;
  EXPECT_THAT(metrics.text(), HasSubstr("dualarm_pool_waiting{pool=\"quick\"} 7\n"));
}

TEST(MetricsEndpoint, ServesMetricsOnLoopbackAndNoFiles) {
  Metrics metrics;
  metrics.count({"undecided", {}, {}, false, 0.0, 0.0, 0.0, 0.0});
  const MetricsEndpoint endpoint("0", metrics);
  EXPECT_THAT(endpoint.address(), StartsWith("127.0.0.1:"));
  const std::string answer = http_get(endpoint.address(), "/metrics");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(answer, HasSubstr("dualarm_answers_total{outcome=\"undecided\"} 1"));
  for (const char* path :
       {"/", "/etc/passwd", "/../../etc/passwd", "/metrics/../../etc/passwd", "/%2e%2e/etc/passwd"}) {
    const std::string refused = http_get(endpoint.address(), path);
    EXPECT_THAT(refused, Not(HasSubstr("HTTP/1.1 200"))) << path;
    EXPECT_THAT(refused, Not(HasSubstr("root:"))) << path;
  }
}

TEST(MetricsEndpoint, SaysThatItsPortIsTaken) {
  const Metrics metrics;
  const MetricsEndpoint first("127.0.0.1:0", metrics);
  try {
    const MetricsEndpoint second(first.address(), metrics);
    ADD_FAILURE() << "two on " << first.address();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot serve metrics on " + first.address()));
  }
}

}  // namespace
}  // namespace dualarm

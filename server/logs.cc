#include "server/logs.h"

#include <google/protobuf/util/json_util.h>
#include <grpc/support/log.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <random>

namespace dualarm {
namespace {

constexpr std::size_t kMostRequestBytes = 64 * 1024;

std::string_view code_name(grpc::StatusCode code) {
  switch (code) {
    case grpc::StatusCode::OK:
      return "OK";
    case grpc::StatusCode::CANCELLED:
      return "CANCELLED";
    case grpc::StatusCode::INVALID_ARGUMENT:
      return "INVALID_ARGUMENT";
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return "DEADLINE_EXCEEDED";
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return "RESOURCE_EXHAUSTED";
    case grpc::StatusCode::UNIMPLEMENTED:
      return "UNIMPLEMENTED";
    case grpc::StatusCode::INTERNAL:
      return "INTERNAL";
    default:
      return "OTHER";
  }
}

std::string new_id() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

// gRPC reports every refused connection as an error of its own; for us it is news, not an error.
void log_for_grpc(gpr_log_func_args* line) {
  const auto level = line->severity == GPR_LOG_SEVERITY_ERROR ? spdlog::level::warn : spdlog::level::debug;
  spdlog::log(level, "grpc: {}", line->message);
}

}  // namespace

void start_logs(const std::string& level) {
  const auto logger =
      std::make_shared<spdlog::logger>("dualarm-server", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %l %v");
  logger->set_level(spdlog::level::from_str(level));
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(logger);
  gpr_set_log_function(log_for_grpc);
}

void log_call(const CallRecord& record) {
  spdlog::info("{} {} queued_ms={:.3f} total_ms={:.3f} {}", record.rpc, code_name(record.code),
               record.queued_milliseconds, record.total_milliseconds, record.note);
}

std::string log_bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request) {
  const std::string id = new_id();
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(request, &json).ok()) json = "(not printable)";
  if (json.size() > kMostRequestBytes) json = json.substr(0, kMostRequestBytes) + "...";
  spdlog::error("bug {} in {}: {}; request: {}", id, rpc, what, json);
  return id;
}

}  // namespace dualarm

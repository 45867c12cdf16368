#include "server/logging/logs.h"

#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/util/json_util.h>
#include <grpc/support/log.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "server/logging/call_log.h"
#include "server/logging/log_format.h"
#include "server/logging/replay_folder.h"
#include "server/logging/request_id.h"

namespace dualarm {
namespace {

constexpr std::size_t kMostRequestBytes = 64 * 1024;

// gRPC reports every refused connection as an error of its own; for us it is news, not an error.
// That the listening socket was ended is a drain's own doing (hang_up.h).
void log_for_grpc(gpr_log_func_args* line) {
  constexpr std::string_view kSocketEnded = "Failed accept4: Invalid argument";
  const bool is_news = line->severity == GPR_LOG_SEVERITY_ERROR && line->message != kSocketEnded;
  const auto level = is_news ? spdlog::level::warn : spdlog::level::debug;
  spdlog::log(level, "grpc: {}", line->message);
}

// Protobuf reports text that is not UTF-8 as an error of its own; whoever sent it is told, and it would fill the log.
void log_for_protobuf(google::protobuf::LogLevel level, const char* /*file*/, int /*line*/,
                      const std::string& message) {
  spdlog::log(level == google::protobuf::LOGLEVEL_FATAL ? spdlog::level::critical : spdlog::level::debug,
              "protobuf: {}", message);
}

// One for the process, as spdlog's default logger is; written before the server's threads begin.
std::unique_ptr<ReplayFolder>& replay_folder() {
  static std::unique_ptr<ReplayFolder> folder;
  return folder;
}

}  // namespace

void start_logs(const std::string& level, bool json) {
  const auto logger =
      std::make_shared<spdlog::logger>("dualarm-server", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_formatter(std::make_unique<LogFormat>(json));
  logger->set_level(spdlog::level::from_str(level));
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(logger);
  gpr_set_log_function(log_for_grpc);
  google::protobuf::SetLogHandler(log_for_protobuf);
}

bool logs_details() { return spdlog::should_log(spdlog::level::debug); }

void log_call(const CallRecord& record) {
  if (!logs_details()) return;
  spdlog::debug("{} ends with {} queued_ms={:.3f} total_ms={:.3f} {}", record.rpc, code_name(record.code),
                record.queued_milliseconds, record.total_milliseconds, record.note);
}

void keep_bugs_in(const std::string& folder, int limit) {
  replay_folder() = std::make_unique<ReplayFolder>(folder, limit);
}

std::string log_bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request) {
  const std::string id = new_request_id();
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(request, &json).ok()) json = "(not printable)";
  if (json.size() > kMostRequestBytes) json = json.substr(0, kMostRequestBytes) + "...";
  spdlog::error("bug {} in {}: {}; request: {}", id, rpc, what, json);
  if (replay_folder() == nullptr) return id;
  const std::string file = replay_folder()->keep(rpc, id, request);
  if (file.empty()) {
    spdlog::warn("bug {} is not kept: the replay folder is full, or cannot be written", id);
  } else {
    spdlog::error("bug {} is kept in {}", id, file);
  }
  return id;
}

}  // namespace dualarm

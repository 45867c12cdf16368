#pragma once

#include <grpcpp/support/status_code_enum.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spdlog {
class logger;
}

namespace dualarm {

/// One thing that a line about a call says, such as "gap" and 0.1.
struct LogField {
  std::string key;
  std::variant<std::string, double, std::int64_t> value;
};

/// What is known of a call when its status goes out.
struct CallReport {
  std::string method;  ///< "PlanMotion"; with its service for services not ours
  grpc::StatusCode code = grpc::StatusCode::OK;
  std::string request_id;
  std::string caller;           ///< name of its token or of its certificate; "" where nobody is known
  double total_seconds = 0.0;   ///< from the request's metadata to its status
  std::vector<LogField> notes;  ///< what came of it
};

/// "OK", "INVALID_ARGUMENT", ...
std::string_view code_name(grpc::StatusCode code);

/// The fields of a report: as text, "PlanMotion OK request_id=7f total_ms=1.252 outcome=plan", or as members of a JSON
/// object, "\"message\":\"call\",\"method\":\"PlanMotion\",...".
std::string text_of(const CallReport& report);
std::string json_members_of(const CallReport& report);

/// One line a call, on the sinks and at the level that the log had when this was made.
class CallLog {
 public:
  explicit CallLog(bool json);

  /// At level info; `routine` calls, such as health checks every few seconds, at debug.
  void write(const CallReport& report, bool routine) const;

 private:
  bool json_;
  std::shared_ptr<spdlog::logger> logger_;  // spdlog's way of holding loggers
};

}  // namespace dualarm

#include "server/logging/call_log.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>

#include "server/logging/log_format.h"

namespace dualarm {
namespace {

constexpr double kMillisecondsInSecond = 1e3;

// RFC 8259 knows no infinity.
std::string json_value(const LogField& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) return json_string(*text);
  if (const auto* count = std::get_if<std::int64_t>(&field.value)) return std::to_string(*count);
  const double number = std::get<double>(field.value);
  return std::isfinite(number) ? fmt::format("{:.9g}", number) : fmt::format("\"{}\"", number);
}

std::string text_value(const LogField& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) {
    const bool plain = !text->empty() && text->find_first_of(" \"=\\") == std::string::npos;
    return plain ? *text : json_string(*text);
  }
  if (const auto* count = std::get_if<std::int64_t>(&field.value)) return std::to_string(*count);
  return fmt::format("{:.9g}", std::get<double>(field.value));
}

std::vector<LogField> fields_of(const CallReport& report) {
  std::vector<LogField> fields = {{"request_id", report.request_id}};
  if (!report.caller.empty()) fields.push_back({"caller", report.caller});
  fields.push_back({"total_ms", std::round(report.total_seconds * kMillisecondsInSecond * 1e3) / 1e3});
  fields.insert(fields.end(), report.notes.begin(), report.notes.end());
  return fields;
}

}  // namespace

std::string_view code_name(grpc::StatusCode code) {
  constexpr std::array<std::string_view, 17> kNames = {
      "OK",        "CANCELLED",      "UNKNOWN",           "INVALID_ARGUMENT",   "DEADLINE_EXCEEDED",
      "NOT_FOUND", "ALREADY_EXISTS", "PERMISSION_DENIED", "RESOURCE_EXHAUSTED", "FAILED_PRECONDITION",
      "ABORTED",   "OUT_OF_RANGE",   "UNIMPLEMENTED",     "INTERNAL",           "UNAVAILABLE",
      "DATA_LOSS", "UNAUTHENTICATED"};
  const auto index = static_cast<std::size_t>(code);
  return index < kNames.size() ? kNames[index] : "OTHER";
}

std::string text_of(const CallReport& report) {
  std::string line = fmt::format("{} {}", report.method, code_name(report.code));
  for (const LogField& field : fields_of(report)) line += fmt::format(" {}={}", field.key, text_value(field));
  return line;
}

std::string json_members_of(const CallReport& report) {
  std::string members = fmt::format("\"message\":\"call\",\"method\":{},\"code\":\"{}\"", json_string(report.method),
                                    code_name(report.code));
  for (const LogField& field : fields_of(report)) {
    members += fmt::format(",{}:{}", json_string(field.key), json_value(field));
  }
  return members;
}

CallLog::CallLog(bool json) : json_(json) {
  const auto log = spdlog::default_logger();
  logger_ = std::make_shared<spdlog::logger>(kFieldsLogger, log->sinks().begin(), log->sinks().end());
  logger_->set_level(log->level());
  logger_->flush_on(log->flush_level());
}

void CallLog::write(const CallReport& report, bool routine) const {
  const auto level = routine ? spdlog::level::debug : spdlog::level::info;
  if (logger_->should_log(level)) logger_->log(level, json_ ? json_members_of(report) : text_of(report));
}

}  // namespace dualarm

#include "server/logging/call_log.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>
#include <iterator>

#include "server/logging/log_format.h"

namespace dualarm {
namespace {

constexpr double kMillisecondsInSecond = 1e3;

using Line = fmt::memory_buffer;
using Value = std::variant<std::string_view, double, std::int64_t>;

Value value_of(const LogField& field) {
  return std::visit([](const auto& value) -> Value { return value; }, field.value);
}

/// Calls visit(key, value) for each field of a report.
template <typename Visit>
void for_each_field(const CallReport& report, Visit visit) {
  visit("request_id", Value(report.request_id));
  if (!report.caller.empty()) visit("caller", Value(report.caller));
  visit("total_ms", Value(std::round(report.total_seconds * kMillisecondsInSecond * 1e3) / 1e3));
  for (const LogField& field : report.notes) visit(field.key, value_of(field));
}

/// In text a word stands as it is; JSON quotes all words, and infinity, which RFC 8259 does not know.
void append(const Value& value, bool json, Line& line) {
  const auto out = std::back_inserter(line);
  if (const auto* text = std::get_if<std::string_view>(&value)) {
    const bool plain = !json && !text->empty() && text->find_first_of(" \"=\\") == std::string_view::npos;
    plain ? fmt::format_to(out, "{}", *text) : fmt::format_to(out, "{}", json_string(*text));
  } else if (const auto* number = std::get_if<double>(&value)) {
    json && !std::isfinite(*number) ? fmt::format_to(out, "\"{}\"", *number) : fmt::format_to(out, "{:.9g}", *number);
  } else {
    fmt::format_to(out, "{}", std::get<std::int64_t>(value));
  }
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
  Line line;
  fmt::format_to(std::back_inserter(line), "{} {}", report.method, code_name(report.code));
  for_each_field(report, [&line](std::string_view key, const Value& value) {
    fmt::format_to(std::back_inserter(line), " {}=", key);
    append(value, false, line);
  });
  return fmt::to_string(line);
}

std::string json_members_of(const CallReport& report) {
  Line line;
  fmt::format_to(std::back_inserter(line), "\"message\":\"call\",\"method\":{},\"code\":\"{}\"",
                 json_string(report.method), code_name(report.code));
  for_each_field(report, [&line](std::string_view key, const Value& value) {
    fmt::format_to(std::back_inserter(line), ",{}:", json_string(key));
    append(value, true, line);
  });
  return fmt::to_string(line);
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

#pragma once

#include <spdlog/formatter.h>

#include <memory>
#include <string>
#include <string_view>

namespace dualarm {

/// Name of the logger whose messages are already made of fields: in text as they are to be seen, in JSON as members of
/// an object without its braces.
inline constexpr char kFieldsLogger[] = "calls";

/// One line for one message, whatever the message holds, so that nobody forges lines:
///   2026-11-23T00:31:11.107+00:00 info listening on 127.0.0.1:50051
///   {"time":"2026-11-23T00:31:11.107+00:00","level":"info","message":"listening on 127.0.0.1:50051"}
class LogFormat final : public spdlog::formatter {
 public:
  explicit LogFormat(bool json) : json_(json) {}

  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override;
  std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<LogFormat>(json_); }

 private:
  bool json_;
};

/// A JSON string with its quotes (RFC 8259). Bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// The text with \n, \r, \t and other control characters as escapes.
std::string on_one_line(std::string_view text);

}  // namespace dualarm

#include "server/logging/log_format.h"

#include <fmt/format.h>
#include <spdlog/details/log_msg.h>
#include <spdlog/details/os.h>

#include <algorithm>
#include <chrono>

namespace dualarm {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD in UTF-8

std::string timestamp(spdlog::log_clock::time_point time) {
  const auto since_epoch = time.time_since_epoch();
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count() % 1000;
  const std::tm local = spdlog::details::os::localtime(spdlog::log_clock::to_time_t(time));
  const int offset = spdlog::details::os::utc_minutes_offset(local);
  const int distance = offset < 0 ? -offset : offset;
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}{}{:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1,
                     local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec, milliseconds, offset < 0 ? '-' : '+',
                     distance / 60, distance % 60);
}

std::string_view view(const spdlog::string_view_t& text) { return {text.data(), text.size()}; }

bool is_control(unsigned char character) { return character < 0x20 || character == 0x7f; }

// Takes the printable ASCII that a text begins with, but for some, to the end of another: most texts are nothing else.
void move_plain(std::string_view& text, std::string_view but_for, std::string& to) {
  const auto is_plain = [&](unsigned char character) {
    return character >= 0x20 && character < 0x7f &&
           but_for.find(static_cast<char>(character)) == std::string_view::npos;
  };
  const auto length = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_plain) - text.begin());
  to += text.substr(0, length);
  text.remove_prefix(length);
}

// The escape of a control character; empty for all others.
std::string escape(unsigned char character) {
  switch (character) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return is_control(character) ? fmt::format("\\u{:04x}", character) : "";
  }
}

// Bytes of the UTF-8 sequence that `text` begins with; 0 where it begins with none (RFC 3629: no overlong forms, no
// surrogates, nothing above U+10FFFF).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool outside = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || outside ? 0 : length;
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    move_plain(text, "\"\\", quoted);
    if (text.empty()) break;
    const char character = text.front();
    const std::size_t length = sequence_length(text);
    if (length == 0) {
      quoted += kReplacement;
    } else if (character == '"' || character == '\\') {
      quoted += {'\\', character};
    } else if (const std::string escaped = escape(static_cast<unsigned char>(character)); !escaped.empty()) {
      quoted += escaped;
    } else {
      quoted += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return quoted + '"';
}

std::string on_one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    move_plain(text, "", line);
    if (text.empty()) break;
    const char character = text.front();
    is_control(static_cast<unsigned char>(character)) ? line += escape(static_cast<unsigned char>(character))
                                                      : line += character;
    text.remove_prefix(1);
  }
  return line;
}

void LogFormat::format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) {
  const std::string time = timestamp(message.time);
  const std::string_view level = view(spdlog::level::to_string_view(message.level));
  const std::string_view text = view(message.payload);
  const bool fields = view(message.logger_name) == kFieldsLogger;
  if (!json_) {
    fmt::format_to(std::back_inserter(line), "{} {} {}\n", time, level, on_one_line(text));
  } else if (fields) {
    fmt::format_to(std::back_inserter(line), "{{\"time\":\"{}\",\"level\":\"{}\",{}}}\n", time, level, text);
  } else {
    fmt::format_to(std::back_inserter(line), "{{\"time\":\"{}\",\"level\":\"{}\",\"message\":{}}}\n", time, level,
                   json_string(text));
  }
}

}  // namespace dualarm

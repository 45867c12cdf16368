#include "server/logging/log_format.h"

#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <spdlog/details/log_msg.h>

#include "tests/support/thread_sanitizer.h"

namespace dualarm {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

std::string formatted(bool json, const std::string& logger, const std::string& text) {
  spdlog::memory_buf_t line;
  LogFormat(json).format({logger, spdlog::level::warn, text}, line);
  return {line.data(), line.size()};
}

// What a strict parser makes of it: the value of "message".
std::string message_of(const std::string& line) {
  google::protobuf::Struct object;
  const auto status = google::protobuf::util::JsonStringToMessage(line, &object);
  EXPECT_TRUE(status.ok()) << line << ": " << status.ToString();
  return object.fields().count("message") == 0 ? "" : object.fields().at("message").string_value();
}

TEST(LogFormat, WritesTimeLevelAndText) {
  EXPECT_THAT(formatted(false, "any", "listening"),
              MatchesRegex("[0-9-]{10}T[0-9:]{8}\\.[0-9]{3}[+-][0-9]{2}:[0-9]{2} warning listening\n"));
}

TEST(LogFormat, KeepsForgedLinesWithinTheirOwn) {
  const std::string line = formatted(false, "any", "one\n2026-01-01 info forged\r\x1b[31m");
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_THAT(line, EndsWith("one\\n2026-01-01 info forged\\r\\u001b[31m\n"));
}

TEST(LogFormat, WritesJsonThatGivesTheTextBack) {
  DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS();
  for (const std::string& text :
       {std::string("plain"), std::string("quote \" and \\ backslash"), std::string("new\nline\ttab\x01"),
        std::string("{\"not\":\"json\"}"), std::string("caf\xc3\xa9 \xf0\x9f\xa6\xbe")}) {
    const std::string line = formatted(true, "any", text);
    EXPECT_EQ(message_of(line), text);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
  }
}

TEST(LogFormat, ReplacesBytesThatAreNoUtf8) {
  DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS();
  EXPECT_EQ(message_of(formatted(true, "any", "a\xff\x62")),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(message_of(formatted(true, "any", "\xc0\xaf")), "\xEF\xBF\xBD\xEF\xBF\xBD");  // overlong
  EXPECT_EQ(message_of(formatted(true, "any", "\xe2\x82")), "\xEF\xBF\xBD\xEF\xBF\xBD");  // cut off
  EXPECT_EQ(json_string("\xed\xa0\x80"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"");     // a surrogate
}

TEST(LogFormat, TakesFieldsAsTheyAre) {
  DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS();
  const std::string line = formatted(true, kFieldsLogger, "\"message\":\"call\",\"gap\":0.5");
  EXPECT_EQ(message_of(line), "call");
  EXPECT_THAT(line, HasSubstr("\"gap\":0.5}"));
}

}  // namespace
}  // namespace dualarm

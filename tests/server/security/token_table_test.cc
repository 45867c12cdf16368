#include "server/security/token_table.h"

#include <gmock/gmock.h>

namespace dualarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kToken[] = "correct-horse-battery-staple";
// printf %s correct-horse-battery-staple | sha256sum
constexpr char kDigest[] = "sha256:87cbebfeebc05f7c54ac9336c4b4bbec831227a641951a4bde7edd56020f8590";

TokenTable table_of(const std::string& text) {
  const auto parsed = TokenTable::parse(text, 8);
  const auto* complaint = std::get_if<std::string>(&parsed);
  if (complaint != nullptr) throw std::runtime_error(*complaint);
  return std::get<TokenTable>(parsed);
}

std::string hexadecimal(const TokenDigest& digest) {
  std::string text;
  for (const unsigned char byte : digest) {
    for (const int nibble : {byte >> 4, byte & 15}) text += "0123456789abcdef"[nibble];
  }
  return text;
}

TEST(TokenTable, DigestsAreSha256) {
  // FIPS 180-4's example.
  EXPECT_EQ(hexadecimal(digest_of("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(TokenTable, KnowsCallersByTheirTokens) {
  const TokenTable table = table_of("# who may call\ncell-4 correct-horse-battery-staple 2 # day shift\n\n" +
                                    ("night sha256:" + hexadecimal(digest_of("another-token-of-length"))) + "\n");
  EXPECT_EQ(table.size(), 2u);
  ASSERT_NE(table.find(kToken), nullptr);
  EXPECT_EQ(table.find(kToken)->name, "cell-4");
  EXPECT_EQ(table.find(kToken)->most_calls, 2);
  ASSERT_NE(table.find("another-token-of-length"), nullptr);
  EXPECT_EQ(table.find("another-token-of-length")->name, "night");
  EXPECT_EQ(table.find("another-token-of-length")->most_calls, 8);
  for (const char* wrong : {"", "correct-horse-battery-stapl", "correct-horse-battery-staple ", "cell-4", kDigest}) {
    EXPECT_EQ(table.find(wrong), nullptr) << wrong;
  }
}

TEST(TokenTable, SaysWhatIsWrongWithALineAndNeverItsToken) {
  const std::string good = std::string("a ") + kToken + "\n";
  for (const auto& [text, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"", "no tokens"},
           {"# nobody\n", "no tokens"},
           {good + "b\n", "line 2: give NAME TOKEN [CALLS]"},
           {std::string("a ") + kToken + " 1 2\n", "line 1: give NAME"},
           {std::string("a/b ") + kToken + "\n", "line 1: a name has"},
           {"a short-token\n", "line 1: a token has at least 16"},
           {"a sha256:1234567890abcdef\n", "line 1: a token has at least 16"},
           {std::string("a ") + kToken + " 0\n", "line 1: calls at once are 1 to"},
           {std::string("a ") + kToken + " many\n", "line 1: calls at once are 1 to"},
           {good + "a another-token-of-length\n", "line 2: the name is taken"},
           {good + "b " + kToken + "\n", "line 2: the token is taken"}}) {
    const auto parsed = TokenTable::parse(text, 8);
    ASSERT_TRUE(std::holds_alternative<std::string>(parsed)) << text;
    EXPECT_THAT(std::get<std::string>(parsed), HasSubstr(complaint));
    EXPECT_THAT(std::get<std::string>(parsed), Not(HasSubstr("short-token")));
    EXPECT_THAT(std::get<std::string>(parsed), Not(HasSubstr(kToken)));
  }
}

}  // namespace
}  // namespace dualarm

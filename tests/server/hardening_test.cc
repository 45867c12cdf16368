// What is shipped, read with readelf: the protections that SECURITY.md promises.
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <string>

namespace dualarm {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string readelf(const std::string& options, const std::string& program) {
  FILE* pipe = popen(("LC_ALL=C readelf --wide " + options + " '" + program + "'").c_str(), "r");
  std::string text;
  std::array<char, 4096> bytes;
  for (std::size_t count = 0; (count = fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    text.append(bytes.data(), count);
  EXPECT_EQ(pclose(pipe), 0) << program;
  return text;
}

class Hardening : public ::testing::TestWithParam<const char*> {};

TEST_P(Hardening, IsPositionIndependent) {
  EXPECT_THAT(readelf("--file-header", GetParam()), ContainsRegex("Type: +DYN"));
  EXPECT_THAT(readelf("--dynamic", GetParam()), ContainsRegex("FLAGS_1.* PIE"));
}

TEST_P(Hardening, BindsAllSymbolsAtStartAndMakesTheirTableReadOnly) {
  EXPECT_THAT(readelf("--program-headers", GetParam()), HasSubstr("GNU_RELRO"));
  EXPECT_THAT(readelf("--dynamic", GetParam()), ContainsRegex("FLAGS.* BIND_NOW"));
}

TEST_P(Hardening, HasNoExecutableStackAndNoPageThatIsWrittenAndRun) {
  const std::string headers = readelf("--program-headers", GetParam());
  EXPECT_THAT(headers, ContainsRegex("GNU_STACK.* RW "));
  EXPECT_THAT(headers, Not(ContainsRegex("(LOAD|GNU_STACK).* RWE ")));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_P(Hardening, ChecksItsStackAndItsBuffers) {
  const std::string symbols = readelf("--dyn-syms", GetParam());
  EXPECT_THAT(symbols, HasSubstr("__stack_chk_fail"));
  EXPECT_THAT(symbols, ContainsRegex("__[a-z]+_chk@GLIBC")) << "no call is fortified";
}
#endif

INSTANTIATE_TEST_SUITE_P(Programs, Hardening, ::testing::Values(DUALARM_SERVER_BINARY, DUALARM_PROGRAM),
                         [](const auto& program) { return program.index == 0 ? "Server" : "Client"; });

}  // namespace
}  // namespace dualarm

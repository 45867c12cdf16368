#include "server/logging/request_id.h"

#include <gmock/gmock.h>

namespace dualarm {
namespace {

TEST(RequestId, IsSixtyFourHarmlessCharactersAtMost) {
  for (const char* good : {"a", "0b5f9c2e-62a3-4c1e-9d1f-2f6a3a3f0e11", "job/7:retry=2", "A.b_c+d"}) {
    EXPECT_TRUE(is_request_id(good)) << good;
  }
  EXPECT_TRUE(is_request_id(std::string(64, 'x')));
  EXPECT_FALSE(is_request_id(std::string(65, 'x')));
  for (const char* bad : {"", "a b", "a\nb", "a\"b", "a{b", "\x01", "\xc3\xa4", "a,b", "a\\b"}) {
    EXPECT_FALSE(is_request_id(bad)) << bad;
  }
}

TEST(RequestId, KeepsWhatTheCallerChoseAndReplacesWhatMayNotBe) {
  EXPECT_EQ(request_id_or_new("job-7"), "job-7");
  for (const char* bad : {"", "forged\nline"}) {
    const std::string id = request_id_or_new(bad);
    EXPECT_EQ(id.size(), 16u);
    EXPECT_TRUE(is_request_id(id));
  }
  EXPECT_NE(new_request_id(), new_request_id());
}

}  // namespace
}  // namespace dualarm

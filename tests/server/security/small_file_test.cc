#include "server/security/small_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

TEST(SmallFile, IsReadWholeUpToAMebibyte) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "file").string();
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, (std::size_t{1} << 20) - 1}) {
    write_file(path, std::string(size, 'x'));
    EXPECT_EQ(small_file(path), std::string(size, 'x'));
  }
  write_file(path, std::string((1 << 20) + 1, 'x'));
  EXPECT_EQ(small_file(path), std::nullopt);
}

TEST(SmallFile, IsNoPipeForWhichTheServerWouldWait) {
  const TemporaryFolder folder;
  const std::string pipe = (folder.path() / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(small_file(pipe), std::nullopt);
  EXPECT_EQ(small_file(folder.path().string()), std::nullopt);
  EXPECT_EQ(small_file("/dev/zero"), std::nullopt);
  EXPECT_EQ(small_file((folder.path() / "nobody").string()), std::nullopt);
}

}  // namespace
}  // namespace dualarm

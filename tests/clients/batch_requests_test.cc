#include "clients/cpp/batch_requests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "clients/cpp/command_error.h"
#include "clients/cpp/json_file.h"
#include "clients/cpp/local_server.h"

namespace dualarm {
namespace {

using planning::v1::PlanMotionBatchRequest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> ids_of(BatchRequests requests) {
  std::vector<std::string> ids;
  while (const auto request = requests.next()) {
    const auto* readable = std::get_if<PlanMotionBatchRequest>(&*request);
    ids.push_back(readable != nullptr ? readable->request_id() : std::get<UnreadableRequest>(*request).error);
  }
  return ids;
}

TEST(BatchRequests, TakeTheFilesOfAFolderInTheOrderOfTheirNames) {
  const PrivateFolder folder;
  for (const char* name : {"b.json", "a.json", "c.json", "readme.md"}) {
    write_text((folder.path() / name).string(), "{\"tasks\": [{\"arm\": \"" + std::string(name) + "\"}]}");
  }
  EXPECT_THAT(ids_of(BatchRequests({folder.path().string()})), ElementsAre("a", "b", "c"));
  BatchRequests requests({(folder.path() / "b.json").string()});
  EXPECT_EQ(std::get<PlanMotionBatchRequest>(*requests.next()).request().tasks(0).arm(), "b.json");
  EXPECT_FALSE(requests.next());
}

TEST(BatchRequests, HaveIdsOfTheirOwn) {
  const PrivateFolder folder;
  const std::string file = (folder.path() / "a.json").string();
  const std::string foreign = (folder.path() / (std::string(100, 'x') + "\xc3\xa4.json")).string();
  write_text(file, "{}");
  write_text(foreign, "{}");
  EXPECT_THAT(ids_of(BatchRequests({file, file, file, foreign})),
              ElementsAre("a", "a #2", "a #3", std::string(48, 'x')));
}

TEST(BatchRequests, SayWhatCannotBeReadAndGoOn) {
  const PrivateFolder folder;
  write_text((folder.path() / "good.json").string(), "{}");
  write_text((folder.path() / "bad.json").string(), "{\"robot\": 7}");
  EXPECT_THAT(
      ids_of(BatchRequests({"/nowhere.json", folder.path().string()})),
      ElementsAre(HasSubstr("/nowhere.json: cannot be read"), HasSubstr("bad.json: is not the JSON form"), "good"));
  const PrivateFolder empty;
  EXPECT_THROW(BatchRequests({empty.path().string()}), CommandError);
}

TEST(BatchRequests, ComeFromStdinLineByLine) {
  std::istringstream lines("{}\n\n{\"robot\": 7}\n{}");
  auto* const before = std::cin.rdbuf(lines.rdbuf());
  const auto ids = ids_of(BatchRequests({"-"}));
  std::cin.rdbuf(before);
  EXPECT_THAT(ids, ElementsAre("line 1", HasSubstr("stdin, line 3: is not the JSON form"), "line 4"));
}

}  // namespace
}  // namespace dualarm

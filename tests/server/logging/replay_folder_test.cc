#include "server/logging/replay_folder.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>

#include "server/logging/logs.h"
#include "tests/server/error_detail.h"
#include "tests/server/paper_request.h"
#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

mode_t mode_of(const std::string& path) {
  struct stat status = {};
  stat(path.c_str(), &status);
  return status.st_mode & 0777;
}

wire::PlanMotionRequest read_back(const std::string& path) {
  wire::PlanMotionRequest request;
  const auto status = google::protobuf::util::JsonStringToMessage(content_of(path), &request);
  EXPECT_TRUE(status.ok()) << status.ToString();
  return request;
}

bool same(const google::protobuf::Message& a, const google::protobuf::Message& b) {
  return google::protobuf::util::MessageDifferencer::Equals(a, b);
}

class ReplayFolderTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(ReplayFolderTest, KeepsTheRequestForTheServersUserAlone) {
  ReplayFolder folder(path("replay"), 3);
  const std::string file = folder.keep("PlanMotion", "0123456789abcdef", paper_request());
  EXPECT_EQ(file, path("replay") + "/PlanMotion-0123456789abcdef.json");
  EXPECT_TRUE(same(read_back(file), paper_request()));
  EXPECT_EQ(mode_of(file), 0600u);
  EXPECT_EQ(mode_of(path("replay")), 0700u);
}

TEST_F(ReplayFolderTest, UnwrapsRequestsOfStreamsAndBatches) {
  ReplayFolder folder(path("replay"), 3);
  wire::PlanMotionStreamRequest stream;
  *stream.mutable_request() = paper_request();
  wire::PlanMotionBatchRequest batch;
  batch.set_request_id("../../etc/cron.d/x");
  *batch.mutable_request() = paper_request();
  EXPECT_TRUE(same(read_back(folder.keep("PlanMotionStream", "a", stream)), paper_request()));
  EXPECT_TRUE(same(read_back(folder.keep("PlanMotionBatch", "b", batch)), paper_request()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("replay")), {}), 2);
}

TEST_F(ReplayFolderTest, KeepsTheFirstOnesWhenItIsFull) {
  ReplayFolder folder(path("replay"), 2);
  EXPECT_NE(folder.keep("PlanMotion", "a", paper_request()), "");
  EXPECT_NE(folder.keep("PlanMotion", "b", paper_request()), "");
  EXPECT_EQ(folder.keep("PlanMotion", "c", paper_request()), "");
  EXPECT_TRUE(std::filesystem::exists(path("replay/PlanMotion-a.json")));
  ReplayFolder after_a_restart(path("replay"), 2);
  EXPECT_EQ(after_a_restart.keep("PlanMotion", "d", paper_request()), "");
  std::filesystem::remove(path("replay/PlanMotion-a.json"));
  EXPECT_NE(folder.keep("PlanMotion", "e", paper_request()), "");
}

TEST_F(ReplayFolderTest, NeverWritesThroughALinkOrOverAFile) {
  ReplayFolder folder(path("replay"), 5);
  write_file(path("precious"), "precious");
  std::filesystem::create_symlink(path("precious"), path("replay/PlanMotion-a.json"));
  EXPECT_EQ(folder.keep("PlanMotion", "a", paper_request()), "");
  EXPECT_EQ(content_of(path("precious")), "precious");
}

TEST_F(ReplayFolderTest, SaysWhereItCannotBe) {
  write_file(path("file"), "");
  EXPECT_THAT(complaint_about_folder(path("file")), HasSubstr("is no folder"));
  EXPECT_THAT(complaint_about_folder(path("no/such/parent")), HasSubstr("cannot write to"));
  EXPECT_EQ(complaint_about_folder(path("to_be_made")), "");
  EXPECT_THROW(ReplayFolder(path("no/such/parent"), 1), std::runtime_error);
}

TEST_F(ReplayFolderTest, HoldsTheRequestOfAnInternalAnswerUnderItsId) {
  ServerOptions options;
  options.replay_dir = path("replay");
  const TestServer server(functions_with_a_bug(), options);
  grpc::ClientContext context;
  wire::PlanMotionResponse response;
  const grpc::Status status = server.stub()->PlanMotion(&context, paper_request(), &response);
  ASSERT_EQ(status.error_code(), grpc::StatusCode::INTERNAL);
  const std::string id = detail_of<google::rpc::ErrorInfo>(status).metadata().at("id");
  EXPECT_TRUE(same(read_back(path("replay/PlanMotion-" + id + ".json")), paper_request()));
}

}  // namespace
}  // namespace dualarm

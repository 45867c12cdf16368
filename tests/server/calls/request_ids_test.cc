#include "server/calls/request_ids.h"

#include <gmock/gmock.h>

#include "tests/server/error_detail.h"

namespace dualarm {
namespace {

using ::testing::HasSubstr;

std::string complaint(RequestIds& ids, const std::string& id) {
  const auto refused = ids.complaint_about(id);
  if (!refused) return "";
  EXPECT_EQ(refused->status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  const auto bad_request = detail_of<google::rpc::BadRequest>(refused->status);
  EXPECT_EQ(bad_request.field_violations_size(), 1);
  EXPECT_EQ(bad_request.field_violations(0).field(), "request_id");
  return bad_request.field_violations(0).description();
}

TEST(RequestIds, AreNamesOfUpToSixtyFourCharacters) {
  RequestIds ids;
  EXPECT_EQ(complaint(ids, "a"), "");
  EXPECT_EQ(complaint(ids, std::string(64, 'x')), "");
  EXPECT_THAT(complaint(ids, ""), HasSubstr("is missing"));
  EXPECT_THAT(complaint(ids, std::string(65, 'x')), HasSubstr("must be at most 64 printable ASCII characters"));
  EXPECT_THAT(complaint(ids, "tab\there"), HasSubstr("is 'tab?here', must be at most 64 printable"));
}

TEST(RequestIds, ComeOnce) {
  RequestIds ids;
  for (int i = 0; i < 100'000; ++i) ASSERT_EQ(complaint(ids, std::to_string(i)), "");
  EXPECT_THAT(complaint(ids, "77777"), HasSubstr("is '77777', which the stream has had already"));
}

TEST(RequestIds, AreRepeatedSoThatTheyCanBeSent) {
  EXPECT_EQ(repeated_id("mine"), "mine");
  EXPECT_EQ(repeated_id(std::string(1000, 'x')), std::string(64, 'x'));
  EXPECT_EQ(repeated_id("\xff,\n"), "'?,?'");
}

TEST(RequestIds, AMillionAreEnoughForOneStream) {
  RequestIds ids;
  for (std::size_t i = 0; i < RequestIds::kMost; ++i) ASSERT_FALSE(ids.complaint_about(std::to_string(i)));
  const auto refused = ids.complaint_about("one more");
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused->status).reason(), "BATCH_TOO_LONG");
}

}  // namespace
}  // namespace dualarm

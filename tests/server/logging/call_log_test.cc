#include "server/logging/call_log.h"

#include <gtest/gtest.h>

#include <limits>

namespace dualarm {
namespace {

CallReport report() {
  return {"PlanMotion", grpc::StatusCode::INVALID_ARGUMENT,
          "job-7",      "cell 4",
          0.0012345678, {{"outcome", "a \"b\""}, {"gap", 0.1}, {"answers", std::int64_t{3}}}};
}

TEST(CallLog, WritesFieldsAsTextOfOneWordEach) {
  EXPECT_EQ(text_of(report()),
            "PlanMotion INVALID_ARGUMENT request_id=job-7 caller=\"cell 4\" total_ms=1.235 outcome=\"a \\\"b\\\"\" "
            "gap=0.1 answers=3");
}

TEST(CallLog, WritesFieldsAsJsonMembers) {
  EXPECT_EQ(json_members_of(report()),
            "\"message\":\"call\",\"method\":\"PlanMotion\",\"code\":\"INVALID_ARGUMENT\",\"request_id\":\"job-7\","
            "\"caller\":\"cell 4\",\"total_ms\":1.235,\"outcome\":\"a \\\"b\\\"\",\"gap\":0.1,\"answers\":3");
}

TEST(CallLog, QuotesInfinityWhichJsonDoesNotKnow) {
  CallReport endless;
  endless.notes = {{"gap", std::numeric_limits<double>::infinity()}};
  EXPECT_NE(json_members_of(endless).find("\"gap\":\"inf\""), std::string::npos) << json_members_of(endless);
}

TEST(CallLog, NamesEveryCode) {
  EXPECT_EQ(code_name(grpc::StatusCode::OK), "OK");
  EXPECT_EQ(code_name(grpc::StatusCode::RESOURCE_EXHAUSTED), "RESOURCE_EXHAUSTED");
  EXPECT_EQ(code_name(grpc::StatusCode::UNAVAILABLE), "UNAVAILABLE");
  EXPECT_EQ(code_name(grpc::StatusCode::UNAUTHENTICATED), "UNAUTHENTICATED");
}

}  // namespace
}  // namespace dualarm

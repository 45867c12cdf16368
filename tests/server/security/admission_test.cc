#include "server/security/admission.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/server/error_detail.h"

namespace dualarm {
namespace {

using Code = grpc::StatusCode;

TokenTable table_of(const std::string& text) { return std::get<TokenTable>(TokenTable::parse(text, 1)); }

const char kLine[] = "a aaaaaaaaaaaaaaaa 2\nb bbbbbbbbbbbbbbbb\n";
const char kA[] = "Bearer aaaaaaaaaaaaaaaa";
const char kB[] = "Bearer bbbbbbbbbbbbbbbb";

TEST(Admission, LetsEverybodyInWhereNoTokensAreSet) {
  Admission admission;
  int call = 0;
  EXPECT_TRUE(admission.enter(&call, "").status.ok());
  EXPECT_TRUE(admission.status_of(&call).ok());
  admission.leave(&call);
}

TEST(Admission, AsksForATokenThatItKnows) {
  Admission admission;
  admission.set_tokens(table_of(kLine));
  int call = 0;
  EXPECT_EQ(admission.status_of(&call).error_code(), Code::UNAUTHENTICATED);
  for (const char* wrong : {"", "aaaaaaaaaaaaaaaa", "Basic aaaaaaaaaaaaaaaa", "bearer"}) {
    const grpc::Status status = admission.enter(&call, wrong).status;
    EXPECT_EQ(status.error_code(), Code::UNAUTHENTICATED);
    EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(status).reason(), "TOKEN_MISSING") << wrong;
    EXPECT_EQ(admission.status_of(&call).error_code(), Code::UNAUTHENTICATED);
    admission.leave(&call);
  }
  const grpc::Status unknown = admission.enter(&call, "Bearer cccccccccccccccc").status;
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(unknown).reason(), "TOKEN_UNKNOWN");
  admission.leave(&call);
  const auto entrance = admission.enter(&call, kA);
  EXPECT_TRUE(entrance.status.ok());
  EXPECT_EQ(entrance.caller, "a");
  EXPECT_TRUE(admission.status_of(&call).ok());
  admission.leave(&call);
  EXPECT_TRUE(admission.enter(&call, "bEARER aaaaaaaaaaaaaaaa").status.ok()) << "names of schemes have no case";
}

TEST(Admission, LimitsCallsAtOnceOfEachTokenAlone) {
  Admission admission;
  admission.set_tokens(table_of(kLine));
  int calls[4] = {};
  EXPECT_TRUE(admission.enter(&calls[0], kA).status.ok());
  EXPECT_TRUE(admission.enter(&calls[1], kA).status.ok());
  const auto refused = admission.enter(&calls[2], kA);
  EXPECT_EQ(refused.status.error_code(), Code::RESOURCE_EXHAUSTED);
  EXPECT_EQ(refused.caller, "a");
  EXPECT_EQ(detail_of<google::rpc::ErrorInfo>(refused.status).reason(), "TOO_MANY_CALLS");
  EXPECT_GT(detail_of<google::rpc::RetryInfo>(refused.status).retry_delay().nanos(), 0);
  EXPECT_TRUE(admission.enter(&calls[3], kB).status.ok());
  admission.leave(&calls[2]);  // was not in: gives nothing back
  EXPECT_FALSE(admission.enter(&calls[2], kA).status.ok());
  admission.leave(&calls[2]);
  admission.leave(&calls[0]);
  EXPECT_TRUE(admission.enter(&calls[2], kA).status.ok());
}

TEST(Admission, ForgetsOldTokensWhenNewOnesAreSet) {
  Admission admission;
  admission.set_tokens(table_of(kLine));
  int before = 0, after = 0;
  EXPECT_TRUE(admission.enter(&before, kA).status.ok());
  admission.set_tokens(table_of("c cccccccccccccccc\n"));
  EXPECT_TRUE(admission.status_of(&before).ok());  // it is in
  EXPECT_FALSE(admission.enter(&after, kA).status.ok());
  admission.leave(&after);
  EXPECT_TRUE(admission.enter(&after, "Bearer cccccccccccccccc").status.ok());
}

TEST(Admission, CountsRightWithManyThreads) {
  Admission admission;
  admission.set_tokens(table_of(kLine));
  std::atomic<int> inside = 0, most = 0, admitted = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 500; ++round) {
        int call = 0;
        if (admission.enter(&call, kA).status.ok()) {
          const int now = ++inside;
          for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
          ++admitted;
          --inside;
        }
        admission.leave(&call);
      }
    });
  }
  threads.clear();
  EXPECT_LE(most, 2);
  EXPECT_GT(admitted, 0);
  int calls[2] = {};
  for (int& call : calls) EXPECT_TRUE(admission.enter(&call, kA).status.ok());  // all places are free again
}

}  // namespace
}  // namespace dualarm

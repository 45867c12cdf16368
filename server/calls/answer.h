#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/status.h>

#include <chrono>
#include <exception>
#include <string>
#include <string_view>

#include "server/request/violations.h"

namespace dualarm {

/// How a call, or a request of a batch, ended.
struct Answer {
  grpc::Status status;
  std::string note;                                 ///< a few words for the log
  std::chrono::steady_clock::duration waited = {};  ///< for a worker
};

/// The request is malformed.
Answer refusal(const Violations& violations);

/// Nobody waits for the answer any more. `when`: a few words for the log.
Answer gone(std::string_view when);

/// A bug: logs it with the request, under an id that the caller gets.
Answer bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request);

/// What `work` returns. This is the one outer wrapper: what it throws becomes a bug().
template <typename Work>
auto answer_of(std::string_view rpc, const google::protobuf::Message& request, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& exception) {
    return bug(rpc, exception.what(), request);
  } catch (...) {
    return bug(rpc, "an exception of unknown type", request);
  }
}

}  // namespace dualarm

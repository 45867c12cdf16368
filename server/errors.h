#pragma once

#include <grpcpp/support/status.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "server/request/violations.h"

namespace dualarm {

/// Error statuses of the service. Each carries a google.rpc.Status with ErrorInfo (domain "dualarm") and the details
/// named here.

/// INVALID_ARGUMENT: a BadRequest with every violation, which the message lists too. Both are cut to what fits into the
/// 8 KiB of metadata that gRPC clients take by default; ErrorInfo's metadata "violation_count" says how many there are.
grpc::Status invalid_argument(const Violations& violations);

/// INVALID_ARGUMENT: the bytes are not a message of this type.
grpc::Status malformed_request(std::string_view type);

/// RESOURCE_EXHAUSTED with a RetryInfo: no worker and no place in the queue is free.
grpc::Status overloaded();

/// RESOURCE_EXHAUSTED: a RetryInfo. The caller's token has this many calls at once already.
grpc::Status too_many_calls(int most_calls);

/// UNAUTHENTICATED: no token, or none that the server knows (ErrorInfo TOKEN_MISSING, TOKEN_UNKNOWN).
grpc::Status unauthenticated(std::string_view reason);

/// The same of searches: the quick methods gave no plan.
grpc::Status searches_overloaded();

/// RESOURCE_EXHAUSTED with a RetryInfo: as many streams are open as the server allows.
grpc::Status too_many_streams();

/// RESOURCE_EXHAUSTED: the stream has had `most` requests.
grpc::Status batch_too_long(std::size_t most);

/// UNAVAILABLE: the server drains; what is not answered may be asked of another.
grpc::Status draining();

/// DEADLINE_EXCEEDED: `what` takes longer than the caller waits or the server allows a call; `remedy` says what to ask
/// for instead.
grpc::Status out_of_time(std::string_view what, std::string_view remedy);

/// CANCELLED: nobody waits for the answer any more.
grpc::Status cancelled();

/// INTERNAL: a bug, logged under `id`.
grpc::Status internal_error(const std::string& id);

}  // namespace dualarm

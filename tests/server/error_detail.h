#pragma once

#include <grpcpp/support/error_details.h>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace dualarm {

/// The detail of this type that an error carries; an empty one if it carries none.
template <typename Detail>
Detail detail_of(const google::rpc::Status& error) {
  Detail detail;
  for (const auto& any : error.details()) {
    if (any.UnpackTo(&detail)) return detail;
  }
  return {};
}

template <typename Detail>
Detail detail_of(const grpc::Status& status) {
  google::rpc::Status rich;
  if (!grpc::ExtractErrorDetails(status, &rich).ok()) return {};
  return detail_of<Detail>(rich);
}

}  // namespace dualarm

#pragma once

#include <grpcpp/support/status.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>

#include "server/security/token_table.h"

namespace dualarm {

/// Lets calls in by their callers' tokens, and only so many of one token at once. From any thread.
class Admission {
 public:
  struct Entrance {
    grpc::Status status;  ///< OK, UNAUTHENTICATED, RESOURCE_EXHAUSTED
    std::string caller;   ///< whose token it is; "" where nobody's, or where none are asked for
  };

  /// Asks nobody for tokens.
  Admission() = default;
  Admission(const Admission&) = delete;
  Admission& operator=(const Admission&) = delete;

  /// Asks for these from now on; calls that are in stay in.
  void set_tokens(TokenTable tokens);

  /// A call begins. `call` is any address of its own; `authorization` is the header's value, "Bearer TOKEN".
  Entrance enter(const void* call, std::string_view authorization);

  /// What enter() said to it; UNAUTHENTICATED where tokens are asked for and it never entered.
  grpc::Status status_of(const void* call) const;

  /// The call has ended, whatever enter() said.
  void leave(const void* call);

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const TokenTable> tokens_;  // shared with calls that are looking while it is replaced
  std::unordered_map<const void*, Entrance> entered_;
  std::map<std::string, int> calls_;  // that are in, by the caller's name
};

}  // namespace dualarm

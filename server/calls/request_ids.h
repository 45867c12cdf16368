#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_set>

#include "server/calls/answer.h"

namespace dualarm {

/// The ids of one batch, held against what the wire demands of them.
class RequestIds {
 public:
  /// A batch of more needs another stream: what is kept of an id, some 40 bytes, would grow without end.
  static constexpr std::size_t kMost = 1'000'000;

  /// Notes an id; an error if it is empty, longer than 64 printable ASCII characters, taken already, or one too many.
  std::optional<Answer> complaint_about(std::string_view id);

 private:
  // Of the ids, 64 bits each: of a million different ones two agree, and the second is refused, once in 40 million
  // batches.
  std::unordered_set<std::uint64_t> seen_;
};

/// The id as an answer repeats it: one that is too long is cut, one that is not UTF-8 could not be sent.
std::string repeated_id(std::string_view id);

}  // namespace dualarm

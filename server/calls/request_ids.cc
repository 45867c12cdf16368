#include "server/calls/request_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "server/errors.h"
#include "server/request/field.h"

namespace dualarm {
namespace {

Answer refused(std::string description) {
  Violations violations;
  Field("request_id", violations).complain(std::move(description));
  return refusal(violations);
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

std::optional<Answer> RequestIds::complaint_about(std::string_view id) {
  if (id.empty()) return refused("is missing: give each request of the stream one of its own");
  if (!is_printable(id) || id.size() > ranges::kLongestName) {
    return refused(
        fmt::format("is {}, must be at most {} printable ASCII characters", quoted(id), ranges::kLongestName));
  }
  if (seen_.size() >= kMost) return Answer{batch_too_long(kMost), "too many requests in one batch"};
  static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));
  if (!seen_.insert(std::hash<std::string_view>{}(id)).second) {
    return refused(
        fmt::format("is {}, which the stream has had already: give each request one of its own", quoted(id)));
  }
  return std::nullopt;
}

std::string repeated_id(std::string_view id) {
  if (is_printable(id)) return std::string(id.substr(0, ranges::kLongestName));
  return quoted(id);
}

}  // namespace dualarm

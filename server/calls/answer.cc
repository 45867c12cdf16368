#include "server/calls/answer.h"

#include <fmt/format.h>

#include "server/errors.h"
#include "server/logging/logs.h"

namespace dualarm {

Answer refusal(const Violations& violations) {
  return {invalid_argument(violations), fmt::format("{} violations", violations.count())};
}

Answer gone(std::string_view when) { return {cancelled(), std::string(when)}; }

Answer bug(std::string_view rpc, std::string_view what, const google::protobuf::Message& request) {
  const std::string id = log_bug(rpc, what, request);
  return {internal_error(id), "bug " + id};
}

}  // namespace dualarm

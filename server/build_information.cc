#include "server/build_information.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/common.h>
#include <grpcpp/grpcpp.h>

namespace dualarm {
namespace {

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace

std::vector<Component> built_from() {
  return {
      {"git", kGitDescription},     {"compiler", compiler()},
      {"grpc", grpc::Version()},    {"protobuf", google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION)},
      {"fcl", DUALARM_FCL_VERSION}, {"ompl", DUALARM_OMPL_VERSION}};
}

std::string version_line() {
  std::string parts;
  for (const Component& part : built_from()) {
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", part.name, part.version);
  }
  return fmt::format("dualarm-server {} ({})", DUALARM_VERSION, parts);
}

}  // namespace dualarm

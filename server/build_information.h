#pragma once

#include <string>
#include <vector>

namespace dualarm {

/// Git's description of the tree that was built ("v0.1.0-3-gabc1234-dirty", or the commit alone); "unknown" where it
/// was built outside of git.
extern const char* const kGitDescription;

/// One name and its version: git, compiler, gRPC, Protobuf, FCL, OMPL.
struct Component {
  std::string name;
  std::string version;
};

std::vector<Component> built_from();

/// "dualarm-server 0.1.0 (git abc1234, compiler gcc 12.2.0, grpc 1.51.1, ...)": what --version and the log say.
std::string version_line();

}  // namespace dualarm

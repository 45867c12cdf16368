// The arrows of docs/architecture.md as a table, and the judge that holds one file's #include lines against it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dualarm {

/// One #include that no arrow allows.
struct ForbiddenInclude {
  int line;             ///< 1-based
  std::string target;   ///< what stands between the quotes or the angle brackets
  std::string because;  ///< one sentence
};

/// The room a file belongs to ("core/verification", "server", ...), by the longest folder name that leads to it;
/// empty where the path lies in no room. `path` is relative to the project's root, with forward slashes.
std::string room_of(std::string_view path);

/// Every forbidden #include of the file at `path` with the contents `text`, in the order of the lines.
std::vector<ForbiddenInclude> forbidden_includes(std::string_view path, std::string_view text);

}  // namespace dualarm

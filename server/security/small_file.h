#pragma once

#include <optional>
#include <string>

namespace dualarm {

/// The content of a file the operator named: certificates, keys, tokens. Nothing where it cannot be read, is no regular
/// file, or has more than 1 MiB.
std::optional<std::string> small_file(const std::string& path);

}  // namespace dualarm

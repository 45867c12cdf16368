// What a command prints.
#pragma once

#include <string_view>

namespace dualarm {

/// Writes `text` to stdout and flushes it. Throws CommandError(kFailure) where that fails: a full disk, a closed file.
void print(std::string_view text);

}  // namespace dualarm

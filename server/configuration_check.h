#pragma once

#include <string>
#include <vector>

#include "server/options.h"

namespace dualarm {

/// What keeps a server with these options from starting, sentence by sentence, for the operator: addresses, plaintext
/// or tokens where others could read them, files that cannot be read or are no good. Binds nothing and writes nothing.
std::vector<std::string> complaints_about(const ServerOptions& options);

}  // namespace dualarm

#pragma once

#include <string>

namespace dualarm {

/// PlanMotion against an empty unary RPC of the same server with a reply of the same size, in one run: round trips of
/// one caller, in turn; then answers a second of `callers` callers, each kind for `seconds`. Prints a table row.
int compare_with_empty_call(const std::string& scenario, double seconds, int callers);

}  // namespace dualarm

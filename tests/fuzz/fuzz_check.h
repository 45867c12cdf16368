#pragma once

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace dualarm {

/// Ends the process, as a fuzzer wants it, where an answer is wrong.
inline void fuzz_check(bool holds, std::string_view claim) {
  if (holds) return;
  std::cerr << "does not hold: " << claim << std::endl;
  std::abort();
}

}  // namespace dualarm

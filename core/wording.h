#pragma once

#include <numbers>
#include <sstream>
#include <string>

namespace dualarm {

inline double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// All arguments one after another, numbers with six digits: the sentences of a refusal. Kept out of the code around
/// it, which mostly has nothing to say.
template <class... Parts>
[[gnu::cold, gnu::noinline]] std::string worded(const Parts&... parts) {
  std::ostringstream text;
  text.precision(6);
  (text << ... << parts);
  return text.str();
}

}  // namespace dualarm

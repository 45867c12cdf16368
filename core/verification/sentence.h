#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace dualarm {

/// Words and numbers (nine digits) in one string: the explanation of a violation. Kept out of the code around it, which
/// mostly has nothing to say.
template <typename... Parts>
[[gnu::cold, gnu::noinline]] std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text << std::setprecision(9);
  (text << ... << parts);
  return text.str();
}

}  // namespace dualarm

#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace dualarm {

/// Words and numbers (nine digits) in one string: the explanation of a violation.
template <typename... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text << std::setprecision(9);
  (text << ... << parts);
  return text.str();
}

}  // namespace dualarm

#include "clients/cpp/standard_output.h"

#include <iostream>

#include "clients/cpp/command_error.h"

namespace dualarm {

void print(std::string_view text) {
  std::cout << text << std::flush;
  if (!std::cout) throw CommandError(ExitStatus::kFailure, "stdout: cannot be written");
}

}  // namespace dualarm

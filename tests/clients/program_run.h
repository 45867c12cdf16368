// Runs a program and keeps what it printed.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace dualarm {

struct ProgramResult {
  int exit_status = -1;  ///< 128 + signal where a signal ended it
  std::string out;
  std::string err;
};

/// A program that is running; its stdout and stderr go to files in `folder`.
class ProgramRun {
 public:
  /// `words`: the program and its arguments. `environment`: "NAME=value" settings on top of this process's own.
  /// `input`: what stdin gives.
  ProgramRun(const std::vector<std::string>& words, const std::vector<std::string>& environment,
             const std::string& folder, const std::string& input = "");

  pid_t pid() const { return pid_; }
  /// Waits for the end. Call once.
  ProgramResult wait();

 private:
  std::string folder_;
  pid_t pid_;
};

/// Command lines of all running processes that hold `text`.
std::vector<std::string> processes_with(const std::string& text);

}  // namespace dualarm

// A command of dualarm run as the real program against the real server, in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/clients/program_run.h"

namespace dualarm {

class CommandFixture : public ::testing::Test {
 protected:
  explicit CommandFixture(std::string command) : command_(std::move(command)) {
    std::string name = (std::filesystem::temp_directory_path() / "command-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~CommandFixture() override { std::filesystem::remove_all(folder_); }

  ProgramResult run(std::vector<std::string> arguments, const std::string& input = "") {
    arguments.insert(arguments.begin(), {DUALARM_PROGRAM, command_});
    return ProgramRun(arguments, {"TMPDIR=" + folder_.string()}, folder_.string(), input).wait();
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::string command_;
  std::filesystem::path folder_;
};

}  // namespace dualarm

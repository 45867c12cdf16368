#include "tests/clients/program_run.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dualarm {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void redirect(const std::string& file, int flags, int descriptor) { dup2(open(file.c_str(), flags, 0600), descriptor); }

}  // namespace

ProgramRun::ProgramRun(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                       const std::string& folder, const std::string& input)
    : folder_(folder) {
  std::ofstream(folder + "/in") << input;
  pid_ = fork();
  if (pid_ != 0) return;
  for (const std::string& setting : environment) putenv(strdup(setting.c_str()));
  redirect(folder + "/in", O_RDONLY, STDIN_FILENO);
  redirect(folder + "/out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(folder + "/err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

ProgramResult ProgramRun::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  ProgramResult result;
  result.exit_status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.out = text_of(folder_ + "/out");
  result.err = text_of(folder_ + "/err");
  return result;
}

std::vector<std::string> processes_with(const std::string& text) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::string line = text_of(entry.path() / "cmdline");
    std::replace(line.begin(), line.end(), '\0', ' ');
    if (line.find(text) != std::string::npos) found.push_back(line);
  }
  return found;
}

}  // namespace dualarm

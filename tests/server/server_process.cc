#include "tests/server/server_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace dualarm {
namespace {

constexpr std::chrono::milliseconds kPollPeriod{5};

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

ServerProcess::ServerProcess(std::vector<std::string> arguments) {
  const std::vector<std::string> defaults = {DUALARM_SERVER_BINARY, "--listen", "127.0.0.1:0", "--port-file",
                                             (folder_.path() / "port").string()};
  const bool listens = std::find(arguments.begin(), arguments.end(), "--listen") != arguments.end();
  arguments.insert(arguments.begin(), defaults.begin() + (listens ? 3 : 1), defaults.end());
  arguments.insert(arguments.begin(), defaults[0]);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log = (folder_.path() / "log").string();
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  const int failure = posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot start " + arguments[0]);
}

ServerProcess::~ServerProcess() {
  if (has_exited()) return;
  signal(SIGKILL);
  wait_for_exit();
}

std::string ServerProcess::wait_for_address() {
  while (!has_exited()) {
    const std::string port = content(folder_.path() / "port");
    if (port.ends_with('\n')) return "127.0.0.1:" + port.substr(0, port.size() - 1);
    std::this_thread::sleep_for(kPollPeriod);
  }
  return "";
}

std::string ServerProcess::wait_for_metrics_address() {
  while (!has_exited()) {
    std::smatch found;
    const std::string all = log();
    if (std::regex_search(all, found, std::regex("metrics on http://(127\\.0\\.0\\.1:[0-9]+)/metrics")))
      return found[1];
    std::this_thread::sleep_for(kPollPeriod);
  }
  return "";
}

void ServerProcess::signal(int number) const { kill(pid_, number); }

int ServerProcess::wait_for_exit() {
  while (!has_exited()) std::this_thread::sleep_for(kPollPeriod);
  return WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -1;
}

std::string ServerProcess::log() const { return content(folder_.path() / "log"); }

bool ServerProcess::has_exited() {
  if (pid_ != 0 && waitpid(pid_, &wait_status_, WNOHANG) == pid_) pid_ = 0;
  return pid_ == 0;
}

}  // namespace dualarm

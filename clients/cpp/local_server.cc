#include "clients/cpp/local_server.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "clients/cpp/command_error.h"

namespace dualarm {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kStartTimeout = std::chrono::seconds(10);
constexpr auto kStopTimeout = std::chrono::milliseconds(300);  // nobody waits for its answers any more
constexpr auto kPollPeriod = std::chrono::milliseconds(2);

fs::path server_beside_this_program() {
  const fs::path server = fs::read_symlink("/proc/self/exe").parent_path() / "dualarm-server";
  if (access(server.c_str(), X_OK) == 0) return server;
  throw CommandError(ExitStatus::kUnreachable,
                     "no server beside this program (" + server.string() + "): say where one listens with --server");
}

bool accepts_connections(const fs::path& socket_path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket_path.native().size() >= sizeof(address.sun_path)) {
    throw CommandError(ExitStatus::kUnreachable, "TMPDIR is too long for a socket: " + socket_path.string());
  }
  std::strcpy(address.sun_path, socket_path.c_str());
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return false;
  const bool accepted = connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  close(descriptor);
  return accepted;
}

// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(const char* program, char* const* arguments, const char* log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // the parent ended before the line above took effect
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);  // Ctrl-C is the client's affair: it stops the server in order
  const int output = open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const int input = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execv(program, arguments);
  _exit(127);
}

}  // namespace

PrivateFolder::PrivateFolder() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "dualarm-XXXXXX").string();
  if (!error && mkdtemp(name.data()) == nullptr) error = {errno, std::generic_category()};
  if (error) {
    throw CommandError(ExitStatus::kUnreachable,
                       "no folder for the private server's socket (" + error.message() +
                           "): set TMPDIR to a folder that you may write to, or say where a server listens with "
                           "--server");
  }
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

ChildProcess::ChildProcess(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& log) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) become(program.c_str(), pointers.data(), log.c_str(), parent);
  if (pid_ < 0) throw CommandError(ExitStatus::kUnreachable, "fork: " + std::generic_category().message(errno));
}

ChildProcess::~ChildProcess() {
  if (has_ended()) return;
  kill(pid_, SIGTERM);
  const auto deadline = Clock::now() + kStopTimeout;
  while (!has_ended()) {
    if (Clock::now() > deadline) kill(pid_, SIGKILL);
    std::this_thread::sleep_for(kPollPeriod);
  }
}

bool ChildProcess::has_ended() {
  if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) != 0) pid_ = -1;
  return pid_ < 0;
}

LocalServer::LocalServer(const std::stop_token& stop)
    : process_(server_beside_this_program(), {"--listen", address(), "--drain-seconds", "0"}, log()) {
  const auto deadline = Clock::now() + kStartTimeout;
  while (!accepts_connections(socket())) {
    if (stop.stop_requested()) throw CommandError(ExitStatus::kInterrupted, "interrupted");
    if (process_.has_ended()) throw CommandError(ExitStatus::kUnreachable, "dualarm-server ended:\n" + log_text());
    if (Clock::now() > deadline) {
      throw CommandError(ExitStatus::kUnreachable, "dualarm-server did not start in time:\n" + log_text());
    }
    std::this_thread::sleep_for(kPollPeriod);
  }
}

std::string LocalServer::log_text() const {
  std::ifstream stream(log());
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace dualarm

#include "server/connections/accept.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <mutex>

namespace dualarm {
namespace {

constexpr std::chrono::seconds kBetweenComplaints{10};

int accept_now(int listener, sockaddr* address, socklen_t* size, int flags) {
  return static_cast<int>(syscall(SYS_accept4, listener, address, size, flags));
}

/// A file that is given up for the moment that it takes to accept a connection and to close it. One for the process, as
/// its table of files is.
class SpareFile {
 public:
  static SpareFile& instance() {
    static SpareFile spare;
    return spare;
  }

  /// Closes every connection that waits at the listener.
  void refuse_all(int listener) {
    const std::lock_guard lock(mutex_);
    complain();
    for (;;) {
      close(file_);
      const int connection = accept_now(listener, nullptr, nullptr, SOCK_CLOEXEC);
      if (connection >= 0) close(connection);
      file_ = taken();
      if (connection < 0) return;
    }
  }

 private:
  SpareFile() : file_(taken()) {}

  static int taken() { return open("/dev/null", O_RDONLY | O_CLOEXEC); }

  void complain() {
    const auto now = std::chrono::steady_clock::now();
    if (now < complained_ + kBetweenComplaints) return;
    complained_ = now;
    spdlog::error("no files are left: connections are refused until some are closed; allow more (ulimit -n)");
  }

  std::mutex mutex_;
  int file_;
  std::chrono::steady_clock::time_point complained_{};
};

}  // namespace

void survive_many_connections() {
  SpareFile::instance();
  rlimit files = {};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
}

}  // namespace dualarm

// In place of the C library's, for gRPC too: a program's own functions come first. Where no file is free nothing waits
// any more when it returns, which is what EAGAIN says.
extern "C" int accept4(int listener, sockaddr* __restrict address, socklen_t* __restrict size, int flags) {
  const int connection = dualarm::accept_now(listener, address, size, flags);
  if (connection >= 0 || (errno != EMFILE && errno != ENFILE)) return connection;
  dualarm::SpareFile::instance().refuse_all(listener);
  errno = EAGAIN;
  return -1;
}

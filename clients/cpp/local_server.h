// The dualarm-server that lies beside this program, started on a private socket for as long as one command lasts.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace dualarm {

/// A new folder that only this user can enter; gone with the object.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A child process. It is sent SIGTERM when the object goes, SIGKILL where it has not ended 0.3 s later, and never
/// outlives this process, however that ends.
class ChildProcess {
 public:
  /// Runs `program` with `arguments`; its stdout and stderr go to the file `log`.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool has_ended();

 private:
  pid_t pid_ = -1;
};

/// Starts the server and waits until its socket accepts connections.
/// Throws CommandError(kUnreachable) with the server's log where it cannot be started, CommandError(kInterrupted) where
/// `stop` is requested first. Make it on the thread that ends the process last: the child goes with that thread.
class LocalServer {
 public:
  explicit LocalServer(const std::stop_token& stop);

  std::string address() const { return "unix:" + socket().string(); }

 private:
  std::filesystem::path socket() const { return folder_.path() / "socket"; }
  std::filesystem::path log() const { return folder_.path() / "log"; }
  std::string log_text() const;

  PrivateFolder folder_;
  ChildProcess process_;
};

}  // namespace dualarm

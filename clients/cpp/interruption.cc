#include "clients/cpp/interruption.h"

namespace dualarm {

Interruption::Interruption() {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, signal);
  pthread_sigmask(SIG_BLOCK, &signals_, &signals_before_);
  watcher_ = std::thread([this] {
    int signal = 0;
    sigwait(&signals_, &signal);
    if (!over_) source_.request_stop();
  });
}

Interruption::~Interruption() {
  over_ = true;
  // Wakes the watcher; where it has gone already its handle is still valid until join, and the signal is discarded.
  pthread_kill(watcher_.native_handle(), SIGTERM);
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &signals_before_, nullptr);
}

}  // namespace dualarm

#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace dualarm {

using LoadClock = std::chrono::steady_clock;

/// Durations of calls, and what they say.
class Latencies {
 public:
  void add(LoadClock::duration duration);
  void add(const Latencies& others);

  std::size_t count() const { return seconds_.size(); }

  /// The duration, s, that this share (0 to 1) of the calls does not exceed; 0 without calls.
  double quantile(double share) const;

  /// "p50 0.213 ms, p99 0.471 ms of 20000".
  std::string summary() const;

 private:
  std::vector<double> seconds_;
};

/// Processor time that a process has used, s.
double processor_seconds(int pid);

/// Resident memory of a process, MiB.
double resident_mebibytes(int pid);

}  // namespace dualarm

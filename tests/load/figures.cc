#include "tests/load/figures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace dualarm {

void Latencies::add(LoadClock::duration duration) {
  seconds_.push_back(std::chrono::duration<double>(duration).count());
}

void Latencies::add(const Latencies& others) {
  seconds_.insert(seconds_.end(), others.seconds_.begin(), others.seconds_.end());
}

double Latencies::quantile(double share) const {
  if (seconds_.empty()) return 0.0;
  std::vector<double> sorted = seconds_;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank), sorted.end());
  return sorted[rank];
}

std::string Latencies::summary() const {
  return fmt::format("p50 {:.3f} ms, p99 {:.3f} ms of {}", 1e3 * quantile(0.5), 1e3 * quantile(0.99), count());
}

// The 14th and 15th word; the second may hold spaces, and ends with the last ')'.
double processor_seconds(int pid) {
  constexpr int kWordsBetween = 11;
  std::string line;
  std::getline(std::ifstream(fmt::format("/proc/{}/stat", pid)), line);
  std::istringstream words(line.substr(line.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < kWordsBetween; ++i) words >> skipped;
  double user = 0.0;
  double system = 0.0;
  words >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double resident_mebibytes(int pid) {
  long size = 0;
  long resident = 0;
  std::ifstream(fmt::format("/proc/{}/statm", pid)) >> size >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

}  // namespace dualarm

#pragma once

#include <cstdint>
#include <random>

#include "geometry/interval.h"

namespace dualarm {

/// A search's own source of chance: one seed, one sequence, on every machine and whatever else runs.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Even over [0, 1).
  double fraction() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

  /// Even over an interval of finite ends.
  double in(Interval interval) { return interval.lower + fraction() * interval.length(); }

  /// True with the given probability.
  bool chance(double probability) { return fraction() < probability; }

  /// Even over 0, ..., count - 1; count > 0.
  int below(int count) { return static_cast<int>(fraction() * count); }

  /// Over (-1, 1), symmetric, small steps of all orders of magnitude often: for changes whose right size is not known.
  double step() {
    const double even = 2.0 * fraction() - 1.0;
    return even * even * even * even * even;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace dualarm

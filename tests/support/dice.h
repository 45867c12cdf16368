#pragma once

#include <cstdint>
#include <random>

namespace dualarm {

/// Random numbers that are the same for the same seed.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  double between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(generator_); }
  bool happens(double probability) { return between(0.0, 1.0) < probability; }
  int one_of(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

 private:
  std::mt19937_64 generator_;
};

}  // namespace dualarm

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>

#include "tests/reference/steering_case.h"

// Calls of the steering function with anything in them: moves down to 1e-15 rad, ends at every limit, torques that
// equal gravity to the last digit. ctest makes 10,000; the million of docs/performance.md is
//   DUALARM_STORM_CALLS=1000000 DUALARM_STORM_SEED=1 steering_storm_test

namespace dualarm {
namespace {

constexpr std::uint64_t kCalls = 10000;
constexpr std::size_t kBytes = 160;  // more than any call needs

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

TEST(SteeringStorm, EveryAnswerIsVerifiedOrRefusedForATrueReason) {
  const std::uint64_t calls = from_environment("DUALARM_STORM_CALLS", kCalls);
  const std::uint64_t first = from_environment("DUALARM_STORM_SEED", 1) * 1000000000ULL;
  std::uint64_t motions = 0;
  std::uint64_t failures = 0;
  constexpr std::uint64_t kEnough = 20;
  for (std::uint64_t seed = first; seed < first + calls && failures < kEnough; ++seed) {
    std::mt19937_64 engine(seed);
    std::array<std::uint8_t, kBytes> bytes;
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(engine());
    const SteeringCase steering = steering_case(bytes);
    const SteeringVerdict verdict = judge_steering(steering);
    if (verdict.is_motion) ++motions;
    if (verdict.complaints.empty()) continue;
    ++failures;
    for (const std::string& complaint : verdict.complaints) {
      ADD_FAILURE() << "seed " << seed << ": " << steering << "\n  " << complaint;
    }
  }
  // A storm of refusals would prove little.
  if (failures == 0) {
    EXPECT_GE(motions, calls / 4);
  }
  RecordProperty("motions", std::to_string(motions));
}

}  // namespace
}  // namespace dualarm

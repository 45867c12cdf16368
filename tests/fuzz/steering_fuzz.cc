#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "tests/reference/steering_case.h"

/// One call of the steering function out of any bytes; aborts where the answer is wrong. Entry of libFuzzer (option
/// DUALARM_FUZZ) and of the replay of the kept corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const dualarm::SteeringCase steering = dualarm::steering_case({bytes, size});
  const dualarm::SteeringVerdict verdict = dualarm::judge_steering(steering);
  if (verdict.complaints.empty()) return 0;
  std::cerr << steering << "\n";
  for (const std::string& complaint : verdict.complaints) std::cerr << "  " << complaint << "\n";
  std::abort();
}

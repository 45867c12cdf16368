#include <chrono>
#include <cmath>

#include "core/verification/verify.h"
#include "server/request/requests.h"
#include "server/response/responses.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzzed_message.h"

namespace dualarm {
namespace {

constexpr std::chrono::milliseconds kBudget{20};

void judge(const wire::VerifyMotionRequest& request) {
  const auto parsed = parse(request);
  if (const auto* violations = std::get_if<Violations>(&parsed)) {
    fuzz_check(!violations->empty(), "a refusal names a violation");
    return;
  }
  const auto& wish = std::get<VerifyWish>(parsed);
  const Budget budget(Budget::Clock::now() + kBudget);
  const Verification verification = verify(wish.problem, wish.trajectory, budget, wish.check_end_states);
  for (const Violation& violation : verification.violations) {
    fuzz_check(!violation.explanation.empty(), "a violation has an explanation");
  }
  fuzz_check(!std::isnan(verification.min_clearance), "a clearance is a number");
  if (verification.holds()) {
    fuzz_check(verification.min_clearance >= 0.0, "what is held to be free of collision has a clearance");
  }
  wire::VerifyMotionResponse read_back;
  fuzz_check(read_back.ParseFromString(response_message(verification).SerializeAsString()), "an answer can be read");
}

}  // namespace
}  // namespace dualarm

/// VerifyMotion without its transport, as plan_fuzz.cc is PlanMotion.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  dualarm::wire::VerifyMotionRequest request;
  if (dualarm::read_message(bytes, size, request)) dualarm::judge(request);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
  return dualarm::mutate_bytes<dualarm::wire::VerifyMotionRequest>(bytes, size, most, seed);
}

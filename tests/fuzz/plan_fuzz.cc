#include <chrono>
#include <cmath>
#include <limits>

#include "core/planner.h"
#include "core/verification/verify.h"
#include "server/errors.h"
#include "server/request/requests.h"
#include "server/response/responses.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzzed_message.h"

namespace dualarm {
namespace {

constexpr std::chrono::milliseconds kBudget{20};
constexpr double kBoundTolerance = 1e-9;  // relative; durations hold to that (docs/theory.md)
constexpr std::size_t kMostErrorBytes = 8 * 1024;

void judge_refusal(const Violations& violations) {
  fuzz_check(!violations.empty(), "a refusal names a violation");
  for (const FieldViolation& violation : violations.kept()) {
    fuzz_check(!violation.field.empty() && !violation.description.empty(), "a violation has a field and a reason");
  }
  const grpc::Status status = invalid_argument(violations);
  fuzz_check(status.error_message().size() + status.error_details().size() < kMostErrorBytes, "an error fits");
}

void judge_plan(const Problem& problem, const Plan& plan) {
  const Verification again = verify(problem, plan.trajectory, Budget(), true);
  fuzz_check(again.holds(), "a plan passes verification");
  fuzz_check(std::isfinite(plan.duration) && plan.duration >= 0.0, "a plan has a duration");
  fuzz_check(plan.duration >= plan.certificate.lower_bound * (1.0 - kBoundTolerance), "no plan beats its bound");
}

void judge(const wire::PlanMotionRequest& request) {
  const auto parsed = parse(request);
  if (const auto* violations = std::get_if<Violations>(&parsed)) return judge_refusal(*violations);
  const auto& wish = std::get<PlanWish>(parsed);
  const Outcome outcome = plan(wish.problem, Budget(Budget::Clock::now() + kBudget));
  if (const auto* found = std::get_if<Plan>(&outcome.answer)) judge_plan(wish.problem, *found);
  wire::PlanMotionResponse read_back;
  fuzz_check(read_back.ParseFromString(response_message(outcome).SerializeAsString()), "an answer can be read");
}

}  // namespace
}  // namespace dualarm

/// PlanMotion without its transport: any message is refused with reasons, or answered by what holds. What is thrown is
/// a finding. Entry of libFuzzer (option DUALARM_FUZZ) and of the replay of the kept corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  dualarm::wire::PlanMotionRequest request;
  if (dualarm::read_message(bytes, size, request)) dualarm::judge(request);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
  return dualarm::mutate_bytes<dualarm::wire::PlanMotionRequest>(bytes, size, most, seed);
}

#include "server/planning_functions.h"

#include "core/planner.h"
#include "core/verification/verify.h"

namespace dualarm {
namespace {

class CoreSteps final : public PlanningSteps {
 public:
  CoreSteps(const Problem& problem, const Budget& budget, const Observer& observer) : run_(problem, budget, observer) {}

  std::optional<Outcome> quick() override { return run_.quick(); }
  std::optional<Outcome> in_hand() override { return run_.in_hand(); }
  Outcome search(const Budget& budget) override { return run_.search(budget); }

 private:
  PlanningRun run_;
};

}  // namespace

PlanningFunctions core_functions() {
  return {[](const Problem& problem, const Budget& budget, const Observer& observer) {
            return std::make_unique<CoreSteps>(problem, budget, observer);
          },
          verify, forbidden_region, arm_portrait};
}

}  // namespace dualarm

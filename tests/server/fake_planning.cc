#include "tests/server/fake_planning.h"

#include <stdexcept>
#include <utility>

namespace dualarm {
namespace {

class FakeSteps final : public PlanningSteps {
 public:
  FakeSteps(std::function<Outcome(const Budget&)> planning, const Budget& budget, bool searches,
            std::optional<Outcome> in_hand)
      : planning_(std::move(planning)), budget_(budget), searches_(searches), in_hand_(std::move(in_hand)) {}

  std::optional<Outcome> quick() override {
    if (searches_) return std::nullopt;
    return planning_(budget_);
  }
  std::optional<Outcome> in_hand() override { return in_hand_; }
  Outcome search(const Budget& budget) override { return planning_(budget); }

 private:
  std::function<Outcome(const Budget&)> planning_;
  Budget budget_;
  bool searches_;
  std::optional<Outcome> in_hand_;
};

BeginPlanning steps_of(FakePlanning planning, bool searches, std::optional<Outcome> in_hand = {}) {
  return [planning, searches, in_hand](const Problem& problem, const Budget& budget, const Observer& observer) {
    const auto plan = [planning, &problem, &observer](const Budget& given) {
      return planning(problem, given, observer);
    };
    return std::make_unique<FakeSteps>(plan, budget, searches, in_hand);
  };
}

}  // namespace

BeginPlanning quick_planning(FakePlanning planning) { return steps_of(std::move(planning), false); }

BeginPlanning search_planning(FakePlanning planning) { return steps_of(std::move(planning), true); }

BeginPlanning search_planning(FakePlanning planning, Outcome in_hand) {
  return steps_of(std::move(planning), true, std::move(in_hand));
}

PlanningFunctions quick_functions() {
  return {quick_planning([](const Problem&, const Budget&, const Observer&) {
            return Outcome{Undecided{"quick", {"nothing"}, 0.0, 0.0}, {}};
          }),
          [](const Problem&, const Trajectory&, const Budget&, bool) {
            Verification verification;
            verification.collision_free = true;
            return verification;
          },
          [](const Problem&, int, const Budget&) {
            return std::vector<Contour>{{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
          },
          [](const Problem&, int, int, const Budget&) {
            return ArmPortrait{{}, Undecided{"quick", {}, 0.0, 0.0}};
          }};
}

PlanningFunctions functions_with(BeginPlanning planning) {
  PlanningFunctions functions = quick_functions();
  functions.begin_planning = std::move(planning);
  return functions;
}

PlanningFunctions functions_with_a_bug() {
  return functions_with(quick_planning(
      [](const Problem&, const Budget&, const Observer&) -> Outcome { throw std::logic_error("a bug"); }));
}

Outcome undecided(std::string explanation) { return {Undecided{std::move(explanation), {}, 0.0, 0.0}, {}}; }

Plan plan_of(double duration) {
  Plan plan;
  plan.duration = duration;
  plan.method = Method::kStateTime;
  return plan;
}

}  // namespace dualarm

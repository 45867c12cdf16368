#include "clients/cpp/region_sets.h"

#include "clients/cpp/command_error.h"

namespace dualarm {

using namespace planning::v1;

GetForbiddenRegionRequest region_request(const PlanMotionRequest& scenario, RegionModel model, double clearance_m,
                                         int resolution) {
  GetForbiddenRegionRequest request;
  *request.mutable_robot() = scenario.robot();
  if (scenario.has_scene()) *request.mutable_scene() = scenario.scene();
  request.set_clearance_m(clearance_m);
  request.set_region_model(model);
  request.set_resolution(resolution);
  return request;
}

std::vector<RegionSet> region_sets(const PlanMotionRequest& scenario, int resolution, const RegionCall& call) {
  const double clearance = scenario.options().clearance_m();
  std::vector<RegionSet> sets;
  const auto add = [&](RegionModel model, double margin) {
    const bool is_paper = model == REGION_MODEL_PAPER;
    const std::string name =
        std::string(is_paper ? "paper's set" : "exact set") + (margin > 0.0 ? ", with margin" : "");
    sets.insert(sets.begin(), {name, margin, is_paper, call(region_request(scenario, model, margin, resolution))});
  };
  add(REGION_MODEL_EXACT, 0.0);
  if (clearance > 0.0) add(REGION_MODEL_EXACT, clearance);
  try {
    add(REGION_MODEL_PAPER, 0.0);
    if (clearance > 0.0) add(REGION_MODEL_PAPER, clearance);
  } catch (const CommandError& error) {
    // What is wrong now, and was not before, is the paper's mounting: there is no such set.
    if (error.status() != ExitStatus::kInvalid) throw;
  }
  return sets;
}

std::vector<std::string> left_out(const PlanMotionRequest& scenario) {
  std::string moving;
  std::string fixed;
  for (const Object& object : scenario.scene().objects()) {
    std::string* names = object.has_moving() ? &moving : object.has_fixed() ? &fixed : nullptr;
    if (names != nullptr) *names += (names->empty() ? "" : ", ") + object.name();
  }
  std::vector<std::string> sentences;
  if (!moving.empty()) sentences.push_back("left out, on clocks of their own: " + moving);
  if (!fixed.empty()) sentences.push_back("left out, in the way of one arm only: " + fixed);
  return sentences;
}

}  // namespace dualarm

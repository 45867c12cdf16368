#include "core/fallback/motion_validator.h"

#include <ompl/base/SpaceInformation.h>

#include <cmath>
#include <utility>

#include "core/fallback/state_time_space.h"

namespace dualarm {
namespace {

const Systems& systems_of(const ompl::base::SpaceInformation* space) {
  return space->getStateSpace()->as<StateTimeSpace>()->systems();
}

}  // namespace

bool StateValidity::isValid(const ompl::base::State* state) const {
  if (!si_->satisfiesBounds(state)) return false;
  const JointStates states = StateTimeSpace::states(state);
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (states[arm].velocity == 0.0 && !can_hold(*systems_of(si_)[arm], states[arm])) return false;
  }
  return proof_.slack(positions_of(states)) > 0.0;
}

bool EdgeValidator::checkMotion(const ompl::base::State* from, const ompl::base::State* to) const {
  const bool valid = std::isfinite(si_->distance(from, to)) &&
                     (si_->equalStates(from, to) ||
                      connect(systems_of(si_), proof_, StateTimeSpace::states(from), StateTimeSpace::states(to),
                              {StateTimeSpace::time(from), StateTimeSpace::time(to)}));
  ++(valid ? valid_ : invalid_);
  return valid;
}

bool EdgeValidator::checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                                std::pair<ompl::base::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
  last_valid.second = 0.0;
  return false;
}

}  // namespace dualarm

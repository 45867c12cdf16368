#include "core/fallback/motion_validator.h"

#include <ompl/base/SpaceInformation.h>

#include <algorithm>
#include <cmath>

#include "core/fallback/state_time_space.h"

namespace dualarm {
namespace {

const Systems& systems_of(const ompl::base::SpaceInformation* space) {
  return space->getStateSpace()->as<StateTimeSpace>()->systems();
}

}  // namespace

std::optional<Edge> connect(const Systems& systems, const ClearanceProof& proof, const JointPair& from,
                            const JointPair& to, Interval time) {
  auto first = steer(*systems[0], from[0], to[0]);
  auto second = steer(*systems[1], from[1], to[1]);
  if (!first || !second) return std::nullopt;
  const std::array<ProfileTable, kArmCount> tables = {ProfileTable(*first), ProfileTable(*second)};
  const double duration = std::max({tables[0].duration(), tables[1].duration(), time.length()});
  const std::array<double, kArmCount> latest = {duration - tables[0].duration(), duration - tables[1].duration()};
  const JointPair together = {0.0, 0.0};
  for (const JointPair& starts : {together, latest}) {
    if (proof.proves({Track{{time.lower + starts[0], &tables[0]}}, Track{{time.lower + starts[1], &tables[1]}}},
                     {time.lower, time.lower + duration})) {
      return Edge{{TimedProfile{starts[0], std::move(*first)}, TimedProfile{starts[1], std::move(*second)}}, duration};
    }
    if (latest == together) break;
  }
  return std::nullopt;
}

bool RestValidity::isValid(const ompl::base::State* state) const {
  const JointPair positions = StateTimeSpace::positions(state);
  return holdable(systems_of(si_), positions) && proof_.slack(positions) > 0.0;
}

bool EdgeValidator::checkMotion(const ompl::base::State* from, const ompl::base::State* to) const {
  const bool valid = std::isfinite(si_->distance(from, to)) &&
                     connect(systems_of(si_), proof_, StateTimeSpace::positions(from), StateTimeSpace::positions(to),
                             {StateTimeSpace::time(from), StateTimeSpace::time(to)});
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

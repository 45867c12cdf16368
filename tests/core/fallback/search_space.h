#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <memory>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/motion_validator.h"
#include "core/fallback/state_time_space.h"
#include "tests/core/fallback/scenes.h"

namespace dualarm {

/// A problem put to OMPL, as the search does it.
struct SearchSpace {
  explicit SearchSpace(const Problem& scene, double clearance = 1e-4, std::uint64_t seed = 1)
      : problem(scene),
        arms(problem),
        proof(problem, clearance, unlimited),
        space(std::make_shared<StateTimeSpace>(arms.both(), 20.0, seed)),
        information(std::make_shared<ompl::base::SpaceInformation>(space)) {
    information->setStateValidityChecker(std::make_shared<StateValidity>(information, proof));
    information->setMotionValidator(std::make_shared<EdgeValidator>(information, proof));
    information->setup();
  }

  /// Both arms at rest.
  ompl::base::ScopedState<StateTimeSpace> state(double first_degrees, double second_degrees, double time) const {
    return state({JointState{first_degrees * kDegree, 0.0}, JointState{second_degrees * kDegree, 0.0}}, time);
  }

  ompl::base::ScopedState<StateTimeSpace> state(const JointStates& states, double time) const {
    ompl::base::ScopedState<StateTimeSpace> made(information);
    StateTimeSpace::set(made.get(), states, time);
    return made;
  }

  Budget unlimited;
  Problem problem;
  ArmSystems arms;
  ClearanceProof proof;
  std::shared_ptr<StateTimeSpace> space;
  ompl::base::SpaceInformationPtr information;
};

}  // namespace dualarm

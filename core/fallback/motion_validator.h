#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/edge.h"

namespace dualarm {

/// A state is valid inside the space where all bodies keep the clearance but those that move by themselves (whether
/// they do depends on how long the arms rest there, which the edges know), and where an arm at rest can be held. What
/// is told to OMPL; the referred objects outlive it.
class StateValidity final : public ompl::base::StateValidityChecker {
 public:
  StateValidity(const ompl::base::SpaceInformationPtr& space, const ClearanceProof& proof)
      : StateValidityChecker(space), proof_(proof) {}

  bool isValid(const ompl::base::State* state) const override;

 private:
  const ClearanceProof& proof_;
};

/// A motion between two states is valid where an edge leads from one to the other in the time between them: directed,
/// proven at its true times, never sampled. One thread.
class EdgeValidator final : public ompl::base::MotionValidator {
 public:
  EdgeValidator(const ompl::base::SpaceInformationPtr& space, const ClearanceProof& proof)
      : MotionValidator(space), proof_(proof) {}

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;

  /// As above; an edge that does not hold is reported as valid in its first state only.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

  const ClearanceProof& proof() const { return proof_; }

 private:
  const ClearanceProof& proof_;
};

}  // namespace dualarm

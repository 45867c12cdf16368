#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>

#include <array>
#include <optional>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/steering.h"
#include "geometry/interval.h"

namespace dualarm {

/// Both arms from rest to rest: their fastest motions, each begun at a time (s) after the edge's own beginning. An arm
/// that is early holds.
struct Edge {
  std::array<TimedProfile, kArmCount> motions;
  double duration = 0.0;  ///< s, not before the later arrival
};

/// An edge that is proven to keep the clearance during a time (s since the start of the plan): both arms begin together
/// with it, or else each waits so that both arrive together at its end. A time too short for the motions is extended.
/// None where neither can be proven. The same positions and time give the same edge.
std::optional<Edge> connect(const Systems& systems, const ClearanceProof& proof, const JointPair& from,
                            const JointPair& to, Interval time);

/// A state is valid where both arms can be held and all bodies keep the clearance but those that move by themselves:
/// whether they do depends on how long the arms rest there, which the edges know. What is told to OMPL; the referred
/// objects outlive it.
class RestValidity final : public ompl::base::StateValidityChecker {
 public:
  RestValidity(const ompl::base::SpaceInformationPtr& space, const ClearanceProof& proof)
      : StateValidityChecker(space), proof_(proof) {}

  bool isValid(const ompl::base::State* state) const override;

 private:
  const ClearanceProof& proof_;
};

/// A motion between two states is valid where an edge leads from one to the other in the time between them: directed,
/// proven, never sampled. One thread.
class EdgeValidator final : public ompl::base::MotionValidator {
 public:
  EdgeValidator(const ompl::base::SpaceInformationPtr& space, const ClearanceProof& proof)
      : MotionValidator(space), proof_(proof) {}

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;

  /// As above; an edge that does not hold is reported as valid in its first state only.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  const ClearanceProof& proof_;
};

}  // namespace dualarm

#pragma once

#include <array>
#include <optional>

#include "core/model/budget.h"
#include "core/model/problem.h"
#include "core/passage/bound.h"

namespace dualarm {

/// A duration below which no plan can be, whatever its motions, and the gate that says so.
struct PassageProof {
  double duration = 0.0;     ///< s; 0 where nothing is proven, infinite where no path leads from start to goal
  std::optional<Gate> gate;  ///< nothing where no gate is to blame
};

/// A duration (s, at most `longest`) below which no motion of one arm gets from its start to its goal: that of the
/// fastest motion of a relaxed arm, in the joint range that is reachable until then. Theory, section 4.
double fastest_proof(const Problem& problem, int arm, double longest);

/// The part of a passage bound of the arms of a problem that is proven for all motions: as far as their families of
/// motions are complete (complete_until), in the joint ranges that are reachable within the bound. Theory, section 4.
PassageProof proof_of(const PassageBound& bound, const Problem& problem);

/// The passage bound at a clearance (m), proven for every pair of motions that stays in the joint ranges of the
/// problem: of relaxed arms, where the families of the arms themselves are not proven to be complete. It looks at
/// durations up to `longest` (s) only, and proves no more. `near_by`: as to passage_bound.
PassageProof passage_proof(const Problem& problem, double clearance, double longest, const Budget& budget,
                           const std::vector<Way>& near_by = {});

}  // namespace dualarm

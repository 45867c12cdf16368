#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/model/budget.h"
#include "core/phase_plane/portrait.h"
#include "core/plan.h"

namespace dualarm {

/// One arm's fastest motion with nothing in its way, as arcs and as states along it.
struct DrawnMotion {
  double duration = 0.0;     ///< s
  double lower_bound = 0.0;  ///< s, of every motion of any kind
  /// kOptimal and kOptimalMonotone are proven, kGap says that it is the fastest of those that were searched.
  Claim claim = Claim::kGap;
  std::vector<Arc> arcs;           ///< empty where the arm stands still
  std::vector<double> times;       ///< s, ascending from 0, with the ends of all arcs
  std::vector<JointState> states;  ///< at these times
};

struct ArmPortrait {
  PhasePortrait curves;
  std::variant<DrawnMotion, Infeasible, Undecided> motion;
};

/// The phase plane of an arm with all that it carries, for its task; fixed objects and the other arm are not in the
/// way. About `resolution` >= 2 states a curve. Nothing where the budget ran out. Theory, section 1.2 [paper, figures
/// 3, 4].
std::optional<ArmPortrait> arm_portrait(const Problem& problem, int arm, int resolution, const Budget& budget);

}  // namespace dualarm

#pragma once

#include <optional>
#include <vector>

#include "core/model/budget.h"
#include "core/model/interval_set.h"
#include "core/model/problem.h"
#include "core/phase_plane/profile.h"

namespace dualarm {

/// The start times (s since the start of the plan; ends may be infinite) with which a motion of the arm on `base`
/// collides with objects that move by themselves: the projection of { (own time, time of the plan) : closer than
/// `clearance` } along the diagonal. `bodies` move with the arm, in its link frame. Nothing happens before time 0. The
/// arm stands at its start before it starts; at its goal it is expected to stay as long as the objects move and
/// afterwards, so that one that passes there later forbids all earlier starts; an arm that is still in motion at its
/// goal is not, since the plan ends with it. As exact as forbidden_delays: ends are polished to 1e-9 s, and proven to
/// 1e-4 of the motion's duration; windows narrower than twice that may be counted as forbidden. Nothing if the budget
/// ran out. Theory, section 3.
std::optional<IntervalSet> forbidden_starts(const Profile& motion, const Base& base, const std::vector<Body>& bodies,
                                            const std::vector<TrackedBody>& objects, double clearance,
                                            const Budget& budget);

}  // namespace dualarm

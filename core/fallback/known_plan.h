#pragma once

#include <optional>
#include <vector>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/itinerary.h"

namespace dualarm {

/// A motion as few fastest motions in a row, which steering makes again, so that the states between them can be
/// changed.
std::vector<Profile> fastest_parts(const System& system, const Profile& motion);

/// What a schedule that was made elsewhere does, as an itinerary between these ends.
Itinerary itinerary_of(const Systems& systems, const JointStates& start, const JointStates& goal,
                       const Arrivals& arrivals, const Schedule& schedule);

/// An itinerary as it is or, where it touches what has to be kept clear, a little longer: one arm first, the other one
/// later. No arm first moves later than `max_start_delay` (s). Nothing where none is proven.
std::optional<Itinerary> proven_free(const ClearanceProof& proof, const Itinerary& itinerary, double max_start_delay);

}  // namespace dualarm

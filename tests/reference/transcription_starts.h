#pragma once

#include <cstdint>
#include <vector>

#include "tests/reference/transcription_scene.h"

namespace dualarm {

inline constexpr int kStretches = 6;  // of an arm: two swings, a stop between them, and one to spare

/// Scripts to begin an optimisation with, best first: crude straight motions and motions by way of a random place, with
/// one arm or the other waiting, or none: of `draws` random ones the best of each of these 12 kinds, at most `most`.
/// The same for the same seed.
std::vector<Scripts> transcription_starts(const Problem& problem, std::uint64_t seed, int draws, int most);

}  // namespace dualarm

#pragma once

#include <array>
#include <cstdint>

#include "core/model/problem.h"

namespace dualarm {

/// What makes a scene hard.
enum class HardKind {
  kThreeZones,     ///< arms cross, objects cross either arm's way, a fixed one is beside it: mixed orders
  kWindows,        ///< trains of balls cross an arm's way with gaps in between
  kBackedRetreat,  ///< both arms have to retreat, objects pass or stand behind them
  kMovingStarts,   ///< arms begin in motion towards each other, among objects
  kMovingRetreat,  ///< the last two together
  kDrives,         ///< like the first, with drives that fade with speed and friction
};

inline constexpr std::array<HardKind, 6> kHardKinds = {HardKind::kThreeZones,    HardKind::kWindows,
                                                       HardKind::kBackedRetreat, HardKind::kMovingStarts,
                                                       HardKind::kMovingRetreat, HardKind::kDrives};

const char* name_of(HardKind kind);

/// A problem, and how long a motion takes that is known to solve it.
struct HardScene {
  Problem problem;
  double witness_duration = 0.0;  ///< s
};

/// A scene that has a solution but none that the planner knows without search: first a witness is drawn, both arms on a
/// random way with rests and waits; then the planner's delays and passages are tried, and objects, fixed and moving
/// ones, are put in the way of what they find, at the place and the time, if they keep clear of the witness; until
/// nothing is found. Reproducible from its seed.
HardScene hard_scene(HardKind kind, std::uint64_t seed);

}  // namespace dualarm

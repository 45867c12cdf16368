#pragma once

#include <cstdint>
#include <optional>

#include "tests/reference/transcription_scene.h"

namespace dualarm {

/// How hard to look.
struct TranscriptionEffort {
  int rounds = 2;         ///< of draws
  int draws = 400;        ///< random scripts that a round's starts are chosen from
  int kinds = 12;         ///< at most 12: optimisations after each round of draws, from the best starts
  int evaluations = 150;  ///< of one optimisation
  std::uint64_t seed = 1;
};

/// What may be missing of an optimiser's motion when it is integrated again in small steps and measured at 4,000
/// instants (and between these where arms are near). Velocity and torque limits are kept by construction.
inline constexpr double kEndTolerance = 1e-4;        // rad and rad/s
inline constexpr double kRangeTolerance = 1e-4;      // rad
inline constexpr double kClearanceTolerance = 1e-4;  // m, the margin that the planner keeps for itself
inline constexpr double kTorqueTolerance = 1e-6;     // N m, that a cruise lacks: rounding

/// The fastest motion found by an optimiser, and what a closer look at it shows.
struct Transcribed {
  double duration = 0.0;  ///< s
  Scripts scripts;
  Rehearsal close;     ///< the same scripts in small steps and at many instants
  bool holds = false;  ///< within the tolerances above
};

struct Transcription {
  std::optional<Transcribed> best;  ///< the fastest that holds; empty if no start led to one
  int runs = 0;                     ///< optimisations
  int held = 0;                     ///< of which the result holds; the others are discarded
};

/// Direct transcription of the minimum-time problem of both arms, by shooting: each arm waits and then plays stretches
/// of constant torque, whose lengths and torques are the variables; NLopt's SLSQP minimises the duration, from many
/// starts, under the ends, the ranges and the smallest separation in each part of the time. Shares nothing with the
/// planner. For problems as in `rehearse`.
Transcription transcribe(const Problem& problem, const TranscriptionEffort& effort = {});

}  // namespace dualarm

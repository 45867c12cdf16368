#pragma once

namespace dualarm {

/// How much of what a request may hold; the operator may choose other numbers.
struct RequestLimits {
  int objects = 1000;
  int poses = 10'000;  ///< of one track

  /// Of one arm, and arcs: two arms with this many fill 4 MB, and 4 MiB is what a gRPC client takes by default.
  int knots = 50'000;

  /// Positions or velocities of a torque table, and entries in all: two tables fill a request of 4 MB, which is what a
  /// server takes by default, and a solver that follows every bend stays quick.
  int table_lines = 1000;
  int table_entries = 100'000;
};

inline constexpr RequestLimits kDefaultLimits;

}  // namespace dualarm

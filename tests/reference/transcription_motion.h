#pragma once

#include <vector>

#include "core/model/arm.h"
#include "core/model/problem.h"

namespace dualarm {

/// A while of constant torque.
struct Stretch {
  double duration = 0.0;  ///< s, >= 0
  double share = 0.0;     ///< -1 to 1: the drive's smallest to its largest torque
};

/// What an arm's drive does: it waits at rest, and then plays one stretch after the other.
struct Script {
  double wait = 0.0;  ///< s, >= 0
  std::vector<Stretch> stretches;
  double duration() const;  ///< s, with the wait
};

/// What becomes of an arm with constant torque limits that plays a script: RK4 over equal steps of each stretch. At its
/// velocity limit it stops accelerating (the drive gives only what the limit takes). Afterwards it rests where it is.
class ScriptedMotion {
 public:
  /// `steps` a stretch, >= 1; `start` at rest.
  ScriptedMotion(const Arm& arm, JointState start, const Script& script, int steps);

  JointState end() const { return instants_.back().state; }  ///< with the velocity it has
  double end_time() const { return instants_.back().time; }  ///< s
  double position_at(double time) const;                     ///< rad, cubic between two steps
  Interval swept() const;                                    ///< rad, smallest and largest position
  double torque_shortfall() const { return shortfall_; }     ///< N m, >= 0, that keeping the velocity limit lacks

 private:
  struct Instant {
    double time = 0.0;
    JointState state;
  };

  void push(double duration, JointState state) { instants_.push_back({instants_.back().time + duration, state}); }
  void step(const Arm& arm, double torque, double duration);
  void cruise(const Arm& arm, double velocity, double duration);

  std::vector<Instant> instants_;
  double shortfall_ = 0.0;
};

/// A crude motion from rest to rest: full drive and full braking; empty if there is no such motion of one swing.
std::vector<Stretch> crude_move(const Arm& arm, double from, double to);

/// The share of torque that holds an arm at a position (rad), clamped to -1 to 1.
double holding_share(const Arm& arm, double position);

}  // namespace dualarm

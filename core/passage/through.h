#pragma once

#include <optional>
#include <utility>

#include "core/model/budget.h"
#include "core/phase_plane/profile.h"
#include "core/phase_plane/system.h"

namespace dualarm {

/// One arm on its way: what it has to do, and how it does it fastest with nothing in its way. Refers to the system.
struct Traveller {
  const System* system;
  JointState start;
  JointState goal;
  Profile fastest;  ///< from start to goal
};

/// A motion of an arm that passes a position.
struct Passing {
  double velocity = 0.0;  ///< rad/s, in the position
  double before = 0.0;    ///< s, from the start to the position; infinite where there is no such motion
  double after = 0.0;     ///< s, from the position to the goal; likewise

  double duration() const { return before + after; }
};

/// What is hurried: to be at the position early (arms that go first), or to leave it late (arms that go second).
enum class Hurry { kEarlyArrival, kLateDeparture };

/// A motion as it passes a position (rad) first, or last; nothing if it does not get there.
std::optional<Passing> passing_of(const Profile& motion, double position, Hurry hurry);

/// Of all motions of an arm that pass a position (rad) the fastest, as it arrives there first or leaves it last.
Passing fastest_passing(const Traveller& traveller, double position, Hurry hurry);

/// The family of an arm's motions through a position (rad): fastest motions from the start to a velocity there, and on
/// from it to the goal. At one end of the family the whole motion is the fastest that gets to the position at all; at
/// the other the hurried half is the fastest, full torque all the way, at the cost of overshooting elsewhere. In
/// between the hurried half gets faster and the whole motion slower. Refers to the traveller.
///
/// Up to the duration `complete_until` of the arm (relaxed_arm.h) the family is proven to be complete: no motion of any
/// kind that takes at most T beats the hurried half of within(T). Theory, section 4.
class Through {
 public:
  Through(const Traveller& traveller, double position, Hurry hurry)
      : Through(traveller, position, hurry, fastest_passing(traveller, position, hurry)) {}

  /// With the fastest passing known.
  Through(const Traveller& traveller, double position, Hurry hurry, const Passing& fastest);

  /// Whether any motion of the family exists.
  bool exists() const { return least_.duration() < kNever; }

  bool is_early() const { return hurry_ == Hurry::kEarlyArrival; }

  /// The fastest motion that gets there, and the one whose hurried half is fastest.
  const Passing& least() const { return least_; }
  Passing most() const { return at(1.0); }

  /// The time that is hurried: before or after the position, s.
  double hurried(const Passing& passing) const {
    return hurry_ == Hurry::kEarlyArrival ? passing.before : passing.after;
  }

  /// The motion of the family at a share of the way from `least` (0) to `most` (1).
  Passing at(double share) const;

  /// The motion of at most `duration` (s, at least that of `least`) whose hurried half is the fastest; the hurried half
  /// is never slower than the truth, to rounding, and faster where the budget runs out.
  Passing within(double duration, const Budget& budget = Budget()) const;

  /// A motion of the family as a profile; nothing if there is none.
  std::optional<Profile> motion(const Passing& passing) const;

 private:
  static constexpr double kNever = 1e9;  ///< s

  Passing through_with(double velocity) const;
  double fastest_velocity() const;

  const Traveller* traveller_;
  double position_;
  Hurry hurry_;
  double direction_;  ///< sign of the velocity in the position
  Passing least_;
  double most_velocity_;  ///< rad/s, of `most`
};

}  // namespace dualarm

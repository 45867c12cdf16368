#pragma once

#include <optional>

#include "core/passage/through.h"

namespace dualarm {

/// The motions of an arm that go farther than they have to, and turn back: beyond its goal for an arm that hurries to
/// be somewhere early, beyond its start for one that leaves late. Each of them is two fastest motions, to rest in the
/// turning point and on. The same motions as a `Through`'s, told by where they turn. Refers to the traveller.
class Detours {
 public:
  /// `towards` (rad): on which side the arm has to get away, or comes from.
  Detours(const Traveller& traveller, double towards, Hurry hurry);

  /// The motion that goes `excess` (rad, >= 0) beyond start and goal; nothing if there is none.
  std::optional<Profile> motion(double excess) const;

  /// How far a motion goes beyond start and goal, rad.
  double of(const Profile& motion) const;

 private:
  const Traveller* traveller_;
  double direction_;
  double base_;  ///< rad, of start and goal the one farther that way
};

}  // namespace dualarm

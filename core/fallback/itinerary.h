#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/profile_table.h"
#include "core/fallback/steering.h"

namespace dualarm {

/// For each arm its motions, in order of time, resting in between.
using Schedule = std::array<std::vector<TimedProfile>, kArmCount>;

/// What stays as it was when a rest moves: the wait there, the beginning of the leg after it, or that leg's arrival.
enum class Keep { kWait, kNextStart, kNextArrival };

/// What both arms do, each on its own: legs from rest to rest with waits before them. A value that can be changed; the
/// legs' profiles follow. Changes that no fastest motion exists for return false and leave it as it was.
class Itinerary {
 public:
  /// Both arms standing at their start positions (rad). The systems outlive the itinerary.
  Itinerary(const Systems& systems, const JointPair& start);

  int leg_count(int arm) const { return static_cast<int>(legs_[arm].size()); }
  double wait(int arm, int leg) const { return legs_[arm][leg].wait; }  ///< s, before the leg
  double goal(int arm, int leg) const { return legs_[arm][leg].goal; }  ///< rad, where the leg ends

  /// Adds a motion at a time (s) not before the arm's last one ends; nothing where it leads nowhere.
  bool append(int arm, double start_time, double goal);

  /// Moves the rest between a leg and the next. Where the wait there is long enough, `keep` stays as it was.
  bool move_rest(int arm, int leg, double position, Keep keep);

  /// Makes one leg of a leg and the next; the waits add up.
  bool drop_rest(int arm, int leg);

  /// Makes two legs of one, with a rest at a position in between.
  bool insert_rest(int arm, int leg, double position);

  void set_wait(int arm, int leg, double wait) { legs_[arm][leg].wait = wait; }

  /// Time (s) from the arm's first moving to its last rest; 0 if it never moves.
  double busy_time(int arm) const;

  /// Sum (s) of both arms' waits between their legs.
  double waits_between() const;

  /// Time (s) of the last arrival.
  double duration() const;

  /// Lets one arm begin at 0 and the other end at `end` (s, at least both busy times).
  void align(int leader, double end);

  std::array<Track, kArmCount> tracks() const;  ///< refers to this itinerary
  Schedule schedule() const;                    ///< one motion of no duration where an arm never moves

 private:
  struct Leg {
    double wait;
    double start;  ///< rad; these two as asked for, the profile's own may be rounded
    double goal;
    Profile profile;
    ProfileTable table;
  };

  std::optional<Leg> leg_between(int arm, double wait, double from, double to) const;

  Systems systems_;
  std::array<Leg, kArmCount> standing_;
  std::array<std::vector<Leg>, kArmCount> legs_;
};

}  // namespace dualarm

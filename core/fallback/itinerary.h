#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/fallback/clearance_proof.h"
#include "core/fallback/edge.h"
#include "core/fallback/profile_table.h"
#include "core/fallback/steering.h"

namespace dualarm {

/// What stays as it was when a rest moves: the wait there, the beginning of the leg after it, or that leg's arrival.
enum class Keep { kWait, kNextStart, kNextArrival };

/// When arms have to arrive, apart from as early as they can.
struct Arrivals {
  JointPair earliest = {-1.0, -1.0};  ///< s: before it an object that moves by itself sweeps the goal
};

/// What both arms do, each on its own: legs between states, with waits before those that begin at rest. A value that
/// can be changed; the legs' motions follow. Changes that no fastest motion exists for return false and leave it as it
/// was.
class Itinerary {
 public:
  /// Both arms in their start states. The systems outlive the itinerary.
  Itinerary(const Systems& systems, const JointStates& start, const Arrivals& arrivals = {});

  int leg_count(int arm) const { return static_cast<int>(legs_[arm].size()); }
  double wait(int arm, int leg) const { return legs_[arm][leg].wait; }                ///< s, before the leg
  JointState start(int arm, int leg) const { return legs_[arm][leg].motion->start; }  ///< where the leg begins
  JointState goal(int arm, int leg) const { return legs_[arm][leg].motion->goal; }    ///< where the leg ends
  const Profile& profile(int arm, int leg) const { return legs_[arm][leg].motion->profile; }
  bool may_wait(int arm, int leg) const { return legs_[arm][leg].motion->may_wait; }

  /// Where an arm is before its first leg, and the time (s) at which it has ended its last one.
  JointState start_state(int arm) const { return start_[arm]; }
  double arrival(int arm) const;

  /// Adds a motion to a state at a time (s), which where it begins in motion is when the one before ends; nothing where
  /// it leads nowhere.
  void append(int arm, double start_time, const Profile& profile, JointState goal);

  /// Moves the state between a leg and the next. Where the wait there is long enough, `keep` stays as it was.
  bool move_via(int arm, int leg, JointState state, Keep keep);

  /// Makes one leg of a leg and the next; the waits add up, where the arm can wait.
  bool drop_via(int arm, int leg);

  /// Makes two legs of one, with a state in between.
  bool insert_via(int arm, int leg, JointState state);

  void set_wait(int arm, int leg, double wait);

  /// Time (s) from the arm's first moving to its last arrival; 0 if it never moves.
  double busy_time(int arm) const;

  /// Sum (s) of both arms' waits between their legs.
  double waits_between() const;

  /// Time (s) of the last arrival.
  double duration() const;

  /// Time (s) at which an arm first moves; 0 if it never does.
  double first_start(int arm) const;

  /// Lets one arm begin at 0 and the other end at `end` (s, at least both busy times), as far as they can wait.
  void align(int leader, double end);

  /// Lets arms arrive no sooner than they may, those that are in motion at their goal at `end` (s), by longer waits
  /// where they last rest or else by slowing down. False, and half done, where that cannot be or the budget runs out.
  bool settle(double end, const Budget& budget = Budget());

  /// Lets an arm that would first move later than `latest` (s) take a small step on its way then, and wait there.
  /// False, and half done, where it cannot.
  bool leave_by(int arm, double latest);

  std::array<Track, kArmCount> tracks() const;  ///< refers to this itinerary
  Schedule schedule() const;                    ///< one motion of no duration where an arm never moves

 private:
  /// A motion with what is looked up in it. Shared by the itineraries that a search makes of each other: they differ in
  /// a leg or two, and copying the others would cost more than proving them.
  struct Motion {
    JointState start;  ///< these two as asked for, the profile's own may be rounded
    JointState goal;
    Profile profile;
    ProfileTable table;
    bool may_wait;  ///< before it
  };
  struct Leg {
    double wait;
    std::shared_ptr<const Motion> motion;
    double duration() const { return motion->table.duration(); }
  };

  std::shared_ptr<const Motion> motion_along(int arm, JointState from, JointState to, const Profile& profile) const;
  std::optional<Leg> leg_between(int arm, double wait, JointState from, JointState to) const;
  bool delay(int arm, double by, const Budget& budget);

  Systems systems_;
  JointStates start_;
  Arrivals arrivals_;
  std::array<std::shared_ptr<const Motion>, kArmCount> standing_;
  std::array<std::vector<Leg>, kArmCount> legs_;
};

}  // namespace dualarm

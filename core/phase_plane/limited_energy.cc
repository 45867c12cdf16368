#include "core/phase_plane/limited_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/phase_plane/extremal.h"
#include "core/phase_plane/limit_walk.h"

namespace dualarm {
namespace {

/// How far beyond start and goal the walks begin at most, rad: gravity repeats itself after a revolution. Before that
/// the limit's energy is granted, which is never too little.
constexpr double kRoom = 2.0 * std::numbers::pi;
/// Pieces after which a walk proves nothing.
constexpr int kMostPieces = 24;
/// What energies may be wrong by, (rad/s)2 and, where arcs are integrated, relative to the limit's.
constexpr double kWorkRounding = 1e-12;
constexpr double kTraceError = 1e-8;

/// Walks along a path, driving forwards or braking backwards, with the highest energy that any motion can have at each
/// x: at rest where it turned round, at the limit at most.
class EnergyWalk {
 public:
  /// From one end of the path to the other. `owner` is a state on the path that may have more energy than any motion
  /// that turned round before.
  EnergyWalk(const Path& path, ArcKind kind, JointState owner, double first_energy)
      : path_(path),
        kind_(kind),
        sign_(kind == ArcKind::kAccelerate ? 1.0 : -1.0),
        x_(sign_ > 0.0 ? 0.0 : path.length()),
        end_(sign_ > 0.0 ? path.length() : 0.0),
        owner_(path.x(owner.position)),
        own_(owner.velocity * path.direction() > 0.0 ? energy_of(owner) : 0.0),
        energy_(first_energy) {
    slack_ = kWorkRounding + (path.velocity_matters(kind) ? kTraceError * path.energy_limit() : 0.0);
  }

  /// Where the energy left the limit for the last time before it ran out beyond the owner; nothing if it never did.
  std::optional<double> broken_at() {
    for (int count = 0; count < kMostPieces && x_ != end_; ++count) {
      if (x_ == owner_) grant(own_);
      until_ = is_past_owner(x_) ? end_ : owner_;
      if (energy_ >= path_.energy_limit()) {
        hold();
      } else if (energy_ > 0.0 || can_begin()) {
        follow();
      } else if (is_stuck()) {
        return left_limit_;
      }
    }
    return std::nullopt;
  }

 private:
  bool is_past_owner(double x) const { return sign_ * (x - owner_) >= 0.0; }

  void grant(double energy) {
    if (energy < energy_) return;
    energy_ = energy;
    left_limit_.reset();
  }

  /// Along the limit as far as it can be held, and a piece down from it.
  void hold() {
    const double held = sign_ > 0.0 ? held_forward(path_, x_, until_) : std::max(until_, held_backward(path_, x_));
    x_ = held;
    if (held == until_) return;
    left_limit_ = held;
    energy_ = path_.energy_limit();
    follow();
  }

  void follow() {
    const Extremal arc(path_, kind_, x_, energy_, until_);
    x_ = arc.end();
    energy_ = arc.exit() == Extremal::Exit::kLimit  ? path_.energy_limit()
              : arc.exit() == Extremal::Exit::kRest ? 0.0
                                                    : arc.energy_at(x_);
  }

  /// The next x at which the acceleration at rest changes sign.
  double next_change() const {
    const std::vector<double> cuts = path_.pieces(kind_, 0.0, std::min(x_, until_), std::max(x_, until_));
    return sign_ > 0.0 ? cuts[1] : cuts[cuts.size() - 2];
  }

  /// At rest: whether a motion can begin. It is granted what rounding might take from it.
  bool can_begin() {
    if (sign_ * path_.acceleration(kind_, 0.5 * (x_ + next_change()), 0.0) <= 0.0) return false;
    energy_ = std::min(slack_, path_.energy_limit());
    left_limit_.reset();
    return true;
  }

  /// At rest where none can: whether none gets past, by more than rounding. Else on to where one can begin.
  bool is_stuck() {
    const double next = next_change();
    const Extremal granted(path_, kind_, x_, std::min(slack_, path_.energy_limit()), next);
    if (is_past_owner(x_) && granted.exit() == Extremal::Exit::kRest) return true;
    x_ = next;
    left_limit_.reset();
    return false;
  }

  const Path& path_;
  ArcKind kind_;
  double sign_;
  double x_;
  double end_;
  double owner_;  ///< x of the state that may have more energy
  double own_;    ///< its energy
  double energy_;
  double until_ = 0.0;
  double slack_ = 0.0;
  std::optional<double> left_limit_;
};

/// One of the two walks: the path leads from where its walk may begin to the other state.
std::optional<LimitBreak> broken(const Path& path, ArcKind kind, JointState owner, bool is_cut) {
  const double first = is_cut ? path.energy_limit() : 0.0;
  const auto x = EnergyWalk(path, kind, owner, first).broken_at();
  if (!x) return std::nullopt;
  return LimitBreak{path.position(*x), path.velocity(path.energy_limit()), kind};
}

}  // namespace

std::optional<LimitBreak> limit_break(const System& system, JointState start, JointState goal) {
  if (start.position == goal.position) return std::nullopt;
  const Path there(system, start.position, goal.position);
  if (!std::isfinite(there.energy_limit())) return std::nullopt;
  const bool cut_before = there.room_before() > kRoom;
  const bool cut_after = there.room_after() > kRoom;
  const Interval range = system.range();
  const double first = cut_before ? there.position(-kRoom) : there.direction() > 0.0 ? range.lower : range.upper;
  const double last = cut_after                 ? there.position(there.length() + kRoom)
                      : there.direction() > 0.0 ? range.upper
                                                : range.lower;
  const Path driven(system, first, goal.position);
  if (auto found = broken(driven, ArcKind::kAccelerate, start, cut_before)) return found;
  return broken(Path(system, start.position, last), ArcKind::kBrake, goal, cut_after);
}

}  // namespace dualarm

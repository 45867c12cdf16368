#include "core/phase_plane/swing.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/phase_plane/extremal.h"
#include "core/phase_plane/metered_system.h"
#include "core/phase_plane/minimum.h"
#include "core/phase_plane/turns.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Turns after which the search gives up.
constexpr std::size_t kMostTurns = 16;
/// Accelerations and works that the layers of each first direction, and moving the turning points, may ask for: some
/// 20,000 legs by quadrature for the layers, a tenth of that by integration; a few tenths of a second in all.
constexpr long kMostWork = 3'000'000;
constexpr long kMostMoves = 10'000'000;
/// The same for a search that ends with the first motion.
constexpr long kMostTrials = kMostWork / 10;
/// Turning points of a layer, at most and at least: so many that the work is enough for some layers.
constexpr int kMostPoints = 24;
constexpr int kFewestPoints = 8;
constexpr double kLayersWanted = 6.0;
/// How far beyond start and goal turning points are searched, rad: gravity repeats itself after a revolution.
constexpr double kRoom = 2.0 * std::numbers::pi;
/// Part of the window by which two further swings have to reach farther to be worth a try.
constexpr double kGrowth = 1e-3;
/// Part of a reach left out at its far end, where a motion would creep.
constexpr double kCreeping = 1e-9;
/// Ratio up to which a chain on the grid may be slower than the best one and still win once its turns are moved.
constexpr double kGridError = 1.05;
/// How often the bracket in which a turning point is moved shrinks, by an eighth each time.
constexpr int kShrinkings = 4;
/// Relative gain below which moving the turning points ends, and most rounds of it.
constexpr double kLeastGain = 1e-12;
constexpr int kMostRounds = 40;
/// Bits to which a turning point is found: less than half of the digits, as the time is flat there.
constexpr int kTurnBits = 26;
/// Part of the way to a corner within which a turning point is the corner: legs forgive rounding, and a search for the
/// least time finds what is forgiven and takes it.
constexpr double kCornerShare = 1e-8;
/// Stands for no motion in a minimisation, s.
constexpr double kNoMotion = 1e12;

/// A chain of turning points and the least time found (s) of a motion through them: to the last one while layers grow,
/// to the goal once it is finished.
struct Chain {
  double time = kInfinity;
  std::vector<double> turns;
};

class Search {
 public:
  Search(const System& system, JointState start, JointState goal, double known, const Budget& budget)
      : budget_(budget),
        system_of_answer_(system),
        system_(system),
        relaxation_(system, start, goal),
        start_(start),
        goal_(goal),
        known_(known) {
    const Interval range = system.range();
    window_ = {std::max(range.lower, std::min(start.position, goal.position) - kRoom),
               std::min(range.upper, std::max(start.position, goal.position) + kRoom)};
  }

  std::optional<Profile> run() {
    for (const double direction : {-1.0, 1.0}) {
      work_ends_ = system_.count() + kMostWork;
      if (direction * start_.velocity >= 0.0) search(direction);
    }
    work_ends_ = system_.count() + kMostMoves;
    std::sort(chains_.begin(), chains_.end(), [](const Chain& a, const Chain& b) { return a.time < b.time; });
    std::optional<Profile> fastest;
    for (Chain& chain : chains_) {
      if (chain.time >= kGridError * std::min(known_, on_grid_)) continue;
      polish(chain);
      meet_corners(chain.turns);
      auto arcs = motion_through(system_, start_, chain.turns, goal_);
      auto* found = std::get_if<std::vector<Arc>>(&arcs);
      if (found == nullptr || found->empty()) continue;
      Profile profile(system_of_answer_, std::move(*found));
      if (profile.duration() >= known_) continue;
      known_ = profile.duration();
      fastest = std::move(profile);
    }
    return fastest;
  }

  bool finds_any() {
    wants_any_ = true;
    for (const double direction : {-1.0, 1.0}) {
      work_ends_ = system_.count() + kMostTrials;
      if (direction * start_.velocity >= 0.0) search(direction);
    }
    return on_grid_ < kInfinity;
  }

 private:
  bool may_go_on() const {
    return system_.count() < work_ends_ && !(wants_any_ && on_grid_ < kInfinity) && !budget_.exhausted();
  }

  /// All chains of turns whose first leg goes in a direction, until two further legs reach nothing new.
  void search(double direction) {
    std::vector<Chain> layer = {{0.0, {}}};
    const long begin = system_.count();
    points_ = kMostPoints;
    std::array<Interval, 2> reached = {Interval{0.0, 0.0}, Interval{0.0, 0.0}};
    for (std::size_t count = 1; count <= kMostTurns && may_go_on(); ++count, direction = -direction) {
      const Interval reach = reach_of(layer, direction);
      if (reach.empty()) return;
      layer = next_layer(layer, reach, direction);
      if (layer.empty()) return;
      chains_.emplace_back();
      for (const Chain& chain : layer) finish(chain);
      if (count == 1) choose_points(begin);
      const Interval extent = extent_of(layer);
      Interval& before = reached[count % 2];
      const double change = std::max(std::abs(extent.lower - before.lower), std::abs(extent.upper - before.upper));
      if (count > 2 && change <= kGrowth * window_.length()) return;
      before = extent;
    }
  }

  /// From what the legs of the first layer, to and from each of its points, have cost since `begin`.
  void choose_points(long begin) {
    const double leg = static_cast<double>(system_.count() - begin) / (2.0 * kMostPoints) + 1.0;
    const double points = std::sqrt(static_cast<double>(kMostWork) / (kLayersWanted * leg));
    points_ = static_cast<int>(std::clamp(points, double{kFewestPoints}, double{kMostPoints}));
  }

  static Interval extent_of(const std::vector<Chain>& layer) {
    Interval extent = {layer.front().turns.back(), layer.front().turns.back()};
    for (const Chain& chain : layer) {
      extent = {std::min(extent.lower, chain.turns.back()), std::max(extent.upper, chain.turns.back())};
    }
    return extent;
  }

  /// Where a layer's motions can turn after a leg in a direction.
  Interval reach_of(const std::vector<Chain>& layer, double direction) const {
    Interval reach = {kInfinity, -kInfinity};
    for (const Chain& chain : layer) {
      const double wall = direction > 0.0 ? window_.upper : window_.lower;
      const JointState from = end_of(chain);
      if (direction * (wall - from.position) <= 0.0) continue;
      const Path path(system_, from.position, wall);
      const double energy = std::min(energy_of(from), path.energy_limit());
      const auto turn_after = [&](ArcKind kind) {
        const Extremal arc(path, kind, 0.0, energy, path.length());
        const bool rests = arc.exit() == Extremal::Exit::kRest;
        return rests ? path.position((1.0 - kCreeping) * arc.end()) : wall;
      };
      const double nearest = turn_after(ArcKind::kBrake);
      const double farthest = turn_after(ArcKind::kAccelerate);
      reach = {std::min({reach.lower, nearest, farthest}), std::max({reach.upper, nearest, farthest})};
    }
    return reach.length() > 0.0 ? reach : Interval{1.0, 0.0};
  }

  std::vector<Chain> next_layer(const std::vector<Chain>& layer, Interval reach, double direction) const {
    std::vector<Chain> next;
    for (const double position : points_of(reach, layer.front().turns.empty())) {
      if (!may_go_on()) break;
      Chain chain;
      const Chain* from = nullptr;
      const double rest = relaxation_.duration({position, 0.0}, goal_);
      for (const Chain& before : layer) {
        if (direction * (position - end_of(before).position) <= 0.0) continue;
        const double bound = before.time + relaxation_.duration(end_of(before), {position, 0.0});
        if (bound >= chain.time || bound + rest >= kGridError * std::min(known_, on_grid_)) continue;
        const double time = before.time + leg_time(end_of(before), {position, 0.0});
        if (time < chain.time) {
          chain.time = time;
          from = &before;
        }
      }
      if (from == nullptr || chain.time + rest >= kGridError * std::min(known_, on_grid_)) continue;
      chain.turns = from->turns;
      chain.turns.push_back(position);
      next.push_back(std::move(chain));
    }
    return next;
  }

  /// A grid on the reach, with the corners at which a minimum may lie.
  std::vector<double> points_of(Interval reach, bool is_first) const {
    std::vector<double> points;
    for (int i = 0; i <= points_; ++i)
      points.push_back(std::lerp(reach.lower, reach.upper, i / static_cast<double>(points_)));
    for (const double corner : corners(is_first)) {
      if (reach.contains(corner)) points.push_back(corner);
    }
    return points;
  }

  /// Where full braking brings the start to rest, and where the run-up to the goal begins.
  std::vector<double> corners(bool is_first) const {
    std::vector<double> found;
    if (is_first) {
      if (const auto corner = stop_corner()) found.push_back(*corner);
    }
    if (const auto corner = run_up_corner()) found.push_back(*corner);
    return found;
  }

  std::optional<double> stop_corner() const {
    if (start_.velocity == 0.0) return std::nullopt;
    const auto stop = stop_from(system_, start_);
    const auto* arcs = std::get_if<std::vector<Arc>>(&stop);
    if (arcs == nullptr || arcs->empty()) return std::nullopt;
    return arcs->back().end.position;
  }

  std::optional<double> run_up_corner() const {
    if (goal_.velocity == 0.0) return std::nullopt;
    const auto run_up = run_up_to(system_, goal_);
    const auto* arcs = std::get_if<std::vector<Arc>>(&run_up);
    if (arcs == nullptr || arcs->empty()) return std::nullopt;
    return arcs->front().start.position;
  }

  void finish(const Chain& chain) {
    const double time = chain.time + leg_time(end_of(chain), goal_);
    if (time < chains_.back().time) chains_.back() = {time, chain.turns};
    on_grid_ = std::min(on_grid_, time);
  }

  /// Where a chain has come to; at rest but for the empty one.
  JointState end_of(const Chain& chain) const {
    return chain.turns.empty() ? start_ : JointState{chain.turns.back(), 0.0};
  }

  /// Time of the fastest leg that never turns back; infinite if there is none, or no work left to look for it.
  double leg_time(JointState from, JointState to) const {
    const double direction = to.position - from.position;
    if (!may_go_on() || direction == 0.0 || direction * from.velocity < 0.0 || direction * to.velocity < 0.0)
      return kInfinity;
    const auto leg = motion_through(system_, from, {}, to);
    const auto* arcs = std::get_if<std::vector<Arc>>(&leg);
    if (arcs == nullptr) return kInfinity;
    double time = 0.0;
    for (const Arc& arc : *arcs) time += ArcMotion(system_, arc).duration();
    return time;
  }

  /// Moves one turning point after another to where the time is least, until that gains nothing.
  void polish(Chain& chain) const {
    for (int round = 0; round < kMostRounds && may_go_on(); ++round) {
      for (std::size_t i = 0; i < chain.turns.size() && may_go_on(); ++i) move(chain.turns, i);
      const double time = duration_of(chain.turns);
      if (time > chain.time * (1.0 - kLeastGain)) return;
      chain.time = time;
    }
  }

  /// The bracket shrinks around the best, so that a narrow minimum on a wide grid is not lost.
  void move(std::vector<double>& turns, std::size_t i) const {
    double& turn = turns[i];
    const JointState before = i == 0 ? start_ : JointState{turns[i - 1], 0.0};
    const JointState after = i + 1 == turns.size() ? goal_ : JointState{turns[i + 1], 0.0};
    const auto time_with = [&](double position) {
      return std::min(kNoMotion, leg_time(before, {position, 0.0}) + leg_time({position, 0.0}, after));
    };
    double least = time_with(turn);
    const auto try_at = [&](double position, double time) {
      if (!(time < least)) return;
      turn = position;
      least = time;
    };
    double reach = window_.length() / kMostPoints;
    for (int shrunk = 0; shrunk < kShrinkings; ++shrunk, reach *= 0.125) {
      const auto [position, time] = boost::math::tools::brent_find_minima(
          time_with, std::max(window_.lower, turn - reach), std::min(window_.upper, turn + reach), kTurnBits);
      try_at(position, time);
    }
    std::vector<double> candidates = corners(i == 0);
    candidates.insert(candidates.end(), {window_.lower, window_.upper});
    for (const double position : candidates) try_at(position, time_with(position));
  }

  /// Puts turning points that are next to where full braking ends, or the run-up begins, exactly there.
  void meet_corners(std::vector<double>& turns) const {
    const auto meet = [](double& turn, const std::optional<double>& corner, double end) {
      if (corner && std::abs(turn - *corner) <= kCornerShare * std::abs(*corner - end)) turn = *corner;
    };
    if (turns.empty()) return;
    meet(turns.front(), stop_corner(), start_.position);
    meet(turns.back(), run_up_corner(), goal_.position);
  }

  double duration_of(const std::vector<double>& turns) const {
    double time = 0.0;
    JointState from = start_;
    for (const double position : turns) {
      time += leg_time(from, {position, 0.0});
      from = {position, 0.0};
    }
    return time + leg_time(from, goal_);
  }

  const Budget& budget_;
  const System& system_of_answer_;
  MeteredSystem system_;
  Relaxation relaxation_;
  JointState start_;
  JointState goal_;
  double known_;
  Interval window_;
  bool wants_any_ = false;  ///< the first motion found is enough
  int points_ = kMostPoints;
  long work_ends_ = 0;
  double on_grid_ = kInfinity;  ///< s, of the best chain before turning points are moved
  std::vector<Chain> chains_;   ///< the best of each number of turns and first direction
};

}  // namespace

std::optional<Profile> fastest_swing(const System& system, JointState start, JointState goal, double known,
                                     const Budget& budget) {
  return Search(system, start, goal, known, budget).run();
}

bool finds_swing(const System& system, JointState start, JointState goal, const Budget& budget) {
  return Search(system, start, goal, kInfinity, budget).finds_any();
}

}  // namespace dualarm

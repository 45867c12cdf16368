#include "core/phase_plane/time_optimal.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/phase_plane/ceiling.h"
#include "core/phase_plane/crossing.h"
#include "core/phase_plane/path.h"

namespace dualarm {
namespace {

/// Walks forwards from the start under a ceiling: full acceleration until the ceiling, then along it.
class ForwardWalk {
 public:
  ForwardWalk(const Path& path, const std::vector<Stretch>& ceiling) : path_(path), ceiling_(ceiling) {}

  std::variant<std::vector<Stretch>, Blocked> run() {
    driving_ = Stretch{ArcKind::kAccelerate, 0.0, 0.0, 0.0, 0.0};
    for (const Stretch& above : ceiling_) {
      double x = above.from;
      while (x < above.to) {
        const std::optional<double> reached = driving_ ? drive_under(above, x) : follow(above, x);
        if (!reached)
          return Blocked{BlockReason::kStalls, path_.position(stall_), 0.0, path_.extreme(ArcKind::kAccelerate)};
        x = *reached;
      }
    }
    if (driving_) finish_driving(path_.length());
    return stretches_;
  }

 private:
  /// Drives from x until the ceiling stretch is met or ends; returns where. Nothing if the motion stalls before.
  std::optional<double> drive_under(const Stretch& above, double x) {
    const auto room = [&](double at) { return above.energy_at(path_, at) - driving_->energy_at(path_, at); };
    const std::vector<double> cuts = path_.monotone_pieces(ArcKind::kAccelerate, x, above.to);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (room(cuts[i + 1]) <= 0.0) {
        const double met = room(cuts[i]) > 0.0 ? crossing(room, cuts[i], cuts[i + 1]) : cuts[i];
        finish_driving(met);
        return met;
      }
      if (driving_->energy_at(path_, cuts[i + 1]) <= 0.0) {
        stall_ = crossing([&](double at) { return driving_->energy_at(path_, at); }, cuts[i], cuts[i + 1]);
        return std::nullopt;
      }
    }
    return above.to;
  }

  /// Follows the ceiling stretch from x to its end, or until full acceleration cannot hold the velocity limit.
  std::optional<double> follow(const Stretch& above, double x) {
    double end = above.to;
    if (above.kind == ArcKind::kCruise) {
      const std::vector<double> cuts = path_.monotone_pieces(ArcKind::kAccelerate, x, above.to);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (path_.acceleration(ArcKind::kAccelerate, 0.5 * (cuts[i] + cuts[i + 1])) < 0.0 &&
            path_.work_shows(ArcKind::kAccelerate, cuts[i], cuts[i + 1] - cuts[i], above.anchor_energy)) {
          end = cuts[i];
          driving_ = Stretch{ArcKind::kAccelerate, end, end, end, above.anchor_energy};
          break;
        }
      }
    }
    Stretch followed = above;
    followed.from = x;
    followed.to = end;
    push(followed);
    return end;
  }

  void finish_driving(double x) {
    driving_->to = x;
    push(*driving_);
    driving_.reset();
  }

  void push(const Stretch& stretch) {
    if (stretch.from < stretch.to) stretches_.push_back(stretch);
  }

  const Path& path_;
  const std::vector<Stretch>& ceiling_;
  std::optional<Stretch> driving_;
  double stall_ = 0.0;
  std::vector<Stretch> stretches_;
};

/// The stretches as arcs of the motion; where two meet, both take the state of the meeting point.
std::vector<Arc> to_arcs(const Path& path, const std::vector<Stretch>& stretches) {
  std::vector<Arc> arcs;
  JointState from = {path.position(0.0), 0.0};
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& stretch = stretches[i];
    const bool last = i + 1 == stretches.size();
    const double energy = last ? 0.0 : std::max(0.0, stretches[i + 1].energy_at(path, stretch.to));
    const JointState to = {last ? path.goal() : path.position(stretch.to), path.direction() * std::sqrt(2.0 * energy)};
    arcs.push_back({stretch.kind, 0.0, 0.0, from, to});
    from = to;
  }
  return arcs;
}

std::optional<Blocked> check_end(const System& system, double position, BlockReason outside, BlockReason not_holdable) {
  if (!system.range().contains(position)) return Blocked{outside, position, 0.0, Extreme::kHighest};
  const Interval admissible = system.acceleration(position, 0.0);
  if (admissible.lower > 0.0) return Blocked{not_holdable, position, 0.0, Extreme::kLowest};
  if (admissible.upper < 0.0) return Blocked{not_holdable, position, 0.0, Extreme::kHighest};
  return std::nullopt;
}

bool strong(const System& system) {
  const Interval range = system.range();
  const Interval at_start = system.acceleration(range.lower, 0.0);
  return at_start.lower < 0.0 && at_start.upper > 0.0 && system.zeros(Extreme::kLowest, 0.0, range).empty() &&
         system.zeros(Extreme::kHighest, 0.0, range).empty();
}

/// Duration of a double integrator that may use the range's best accelerations everywhere: a bound for every motion.
double relaxed_duration(const System& system, const Path& path) {
  const Interval bounds = system.acceleration_bounds();
  const bool rising = path.direction() > 0.0;
  const double drive = rising ? bounds.upper : -bounds.lower;
  const double brake = rising ? -bounds.lower : bounds.upper;
  if (!(drive > 0.0 && brake > 0.0)) return 0.0;
  const double inverse_sum = 1.0 / drive + 1.0 / brake;
  const double energy = std::min(path.length() / inverse_sum, path.energy_limit());
  const double peak = std::sqrt(2.0 * energy);
  const double cruise = path.length() - energy * inverse_sum;
  return peak * inverse_sum + cruise / peak;
}

/// What two sums of work may differ by, (rad/s)2, and be the same.
constexpr double kWorkRounding = 1e-12;

/// Whether not even a motion that swings back as far as the range allows gets past. On its way forwards past x it last
/// turned round at some q, so its energy at x is at most the driving work from q to x. If that is negative from every q
/// that the range offers before x, no motion passes x; and it is, where the work from the range's end falls below
/// everything that it was before the start. Theory, section 1.3.
bool impassable(const Path& path, double range_before_start) {
  const auto work = [&](double x) { return path.work(ArcKind::kAccelerate, 0.0, x); };
  const auto least_work = [&](double from, double to) {
    const std::vector<double> cuts = path.monotone_pieces(ArcKind::kAccelerate, from, to);
    double least = work(from);
    for (const double x : cuts) least = std::min(least, work(x));
    return least;
  };
  return least_work(0.0, path.length()) < least_work(-range_before_start, 0.0) - kWorkRounding;
}

/// The same blocked motion with what is known about motions of every kind. Time reversed, braking onto the goal is
/// driving away from it, so both reasons are one.
Blocked judged(Blocked blocked, const System& system, const Path& path, double start, double goal) {
  const Interval range = system.range();
  const bool rising = goal > start;
  if (blocked.reason == BlockReason::kStalls) {
    blocked.is_proven = impassable(path, rising ? start - range.lower : range.upper - start);
  } else {
    blocked.is_proven = impassable(Path(system, goal, start), rising ? range.upper - goal : goal - range.lower);
  }
  blocked.lower_bound = relaxed_duration(system, path);
  return blocked;
}

}  // namespace

std::variant<FastestMotion, Blocked> fastest_motion(const System& system, JointState start_state, JointState goal_state,
                                                    Swings /*swings*/) {
  const double start = start_state.position;
  const double goal = goal_state.position;
  if (auto blocked = check_end(system, start, BlockReason::kStartOutsideRange, BlockReason::kStartNotHoldable)) {
    return *blocked;
  }
  if (auto blocked = check_end(system, goal, BlockReason::kGoalOutsideRange, BlockReason::kGoalNotHoldable)) {
    return *blocked;
  }
  if (start == goal) return FastestMotion{Profile(system, start), MinimumOver::kAllMotions, 0.0};

  const Path path(system, start, goal);
  // At the very limit of what can be held the motion would take for ever.
  const auto judge = [&](const Blocked& blocked) { return judged(blocked, system, path, start, goal); };
  if (!(path.acceleration(ArcKind::kAccelerate, 0.0) > 0.0)) {
    return judge({BlockReason::kStalls, start, 0.0, path.extreme(ArcKind::kAccelerate)});
  }
  if (!(path.acceleration(ArcKind::kBrake, path.length()) < 0.0)) {
    return judge({BlockReason::kCannotBrake, goal, 0.0, path.extreme(ArcKind::kBrake)});
  }
  const auto ceiling = braking_ceiling(path);
  if (const auto* blocked = std::get_if<Blocked>(&ceiling)) return judge(*blocked);
  const auto walked = ForwardWalk(path, std::get<std::vector<Stretch>>(ceiling)).run();
  if (const auto* blocked = std::get_if<Blocked>(&walked)) return judge(*blocked);
  Profile profile(system, to_arcs(path, std::get<std::vector<Stretch>>(walked)));
  if (strong(system)) return FastestMotion{profile, MinimumOver::kAllMotions, profile.duration()};
  return FastestMotion{profile, MinimumOver::kMonotoneMotions, relaxed_duration(system, path)};
}

}  // namespace dualarm

#include "core/phase_plane/stretches.h"

#include <algorithm>

#include "core/phase_plane/ceiling.h"
#include "core/phase_plane/crossing.h"
#include "core/phase_plane/limit_walk.h"

namespace dualarm {
namespace {

/// By how much, relative, energies that should be one may differ: some thousand roundings of the work between them, and
/// some steps' errors where an arc is integrated.
constexpr double kWorkRounding = 1e-11;
constexpr double kTraceError = 1e-9;
/// Rounding of a position (rad, at 1 rad), which times the acceleration is an energy.
constexpr double kPositionRounding = 1e-15;
/// Part of an energy that is forgiven at most.
constexpr double kMostRounding = 1e-3;

/// Walks forwards from the start under a ceiling: full acceleration until the ceiling, then along it.
class ForwardWalk {
 public:
  ForwardWalk(const Path& path, const std::vector<Stretch>& ceiling, double start_energy, double goal_energy)
      : path_(path), ceiling_(ceiling), start_energy_(start_energy), goal_energy_(goal_energy) {
    const double acceleration = std::abs(path.acceleration(ArcKind::kAccelerate, 0.0, start_energy)) +
                                std::abs(path.acceleration(ArcKind::kBrake, 0.0, start_energy));
    position_rounding_ = kPositionRounding * acceleration * (1.0 + std::abs(path.position(0.0)));
  }

  std::variant<std::vector<Stretch>, Obstruction> run() {
    const auto slack = [this](double one, double other) {
      const bool traced = path_.velocity_matters(ArcKind::kAccelerate) || path_.velocity_matters(ArcKind::kBrake);
      return (traced ? kTraceError : kWorkRounding) * std::max(one, other) +
             std::min(position_rounding_, kMostRounding * std::max(one, other));
    };
    const double highest = ceiling_.front().energy_at(path_, 0.0);
    if (start_energy_ > highest + slack(start_energy_, highest))
      return Obstruction{Obstruction::Kind::kOverspeeds, 0.0};
    if (start_energy_ < highest - slack(start_energy_, highest)) {
      driving_.emplace(path_, ArcKind::kAccelerate, 0.0, start_energy_, path_.length());
    }
    for (const Stretch& above : ceiling_) {
      double x = above.from;
      while (x < above.to) {
        if (driving_ && driving_->exit() == Extremal::Exit::kRest && driving_->end() <= x) {
          return Obstruction{Obstruction::Kind::kStalls, driving_->end()};
        }
        x = driving_ ? drive_under(above, x) : follow(above, x);
      }
    }
    if (driving_) {
      const double reached = driving_->energy_at(path_.length());
      if (reached < goal_energy_ - slack(reached, goal_energy_)) {
        return Obstruction{Obstruction::Kind::kFallsShort, path_.length()};
      }
      finish_driving(path_.length());
    }
    return std::move(stretches_);
  }

 private:
  /// Drives from x until the ceiling stretch is met or ends, or the drive's own end; returns where. Where two arcs have
  /// one velocity, driving gains on braking: so they cross once at most.
  double drive_under(const Stretch& above, double x) {
    const double until = std::min(above.to, driving_->end());
    const bool at_limit = driving_->exit() == Extremal::Exit::kLimit && driving_->end() <= above.to;
    if (above.arc) {
      const auto room = [&](double at) { return above.energy_at(path_, at) - driving_->energy_at(at); };
      if (room(until) <= 0.0 || at_limit) {
        double before = x;
        double after = until;
        for (const double node : driving_->nodes(x, until)) {
          (room(node) > 0.0 ? before : after) = node;
          if (after == node) break;
        }
        const double met = room(before) <= 0.0 ? before : room(after) >= 0.0 ? after : crossing(room, before, after);
        finish_driving(met);
        return met;
      }
    } else if (at_limit) {
      finish_driving(until);
    }
    return until;
  }

  /// Follows the ceiling stretch from x to its end, or until full acceleration cannot hold the velocity limit.
  double follow(const Stretch& above, double x) {
    const double end = above.arc ? above.to : held_forward(path_, x, above.to);
    if (end < above.to) driving_.emplace(path_, ArcKind::kAccelerate, end, path_.energy_limit(), path_.length());
    Stretch followed = above;
    followed.from = x;
    followed.to = end;
    push(std::move(followed));
    return end;
  }

  void finish_driving(double x) {
    push({std::move(driving_), drive_start_, x});
    driving_.reset();
  }

  void push(Stretch stretch) {
    drive_start_ = stretch.to;
    if (stretch.from < stretch.to) stretches_.push_back(std::move(stretch));
  }

  const Path& path_;
  const std::vector<Stretch>& ceiling_;
  double start_energy_;
  double goal_energy_;
  double position_rounding_ = 0.0;  ///< as an energy
  std::optional<Extremal> driving_;
  double drive_start_ = 0.0;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::variant<std::vector<Stretch>, Obstruction> fastest_stretches(const Path& path, double start_energy,
                                                                  double goal_energy) {
  // At rest at the very limit of what the drive gives, a motion would take for ever.
  if (start_energy == 0.0 && !(path.acceleration(ArcKind::kAccelerate, 0.0, 0.0) > 0.0)) {
    return Obstruction{Obstruction::Kind::kStalls, 0.0};
  }
  if (goal_energy == 0.0 && !(path.acceleration(ArcKind::kBrake, path.length(), 0.0) < 0.0)) {
    return Obstruction{Obstruction::Kind::kCannotBrake, path.length()};
  }
  const auto ceiling = braking_ceiling(path, goal_energy);
  if (const auto* obstruction = std::get_if<Obstruction>(&ceiling)) return *obstruction;
  return ForwardWalk(path, std::get<std::vector<Stretch>>(ceiling), start_energy, goal_energy).run();
}

}  // namespace dualarm

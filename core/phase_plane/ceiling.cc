#include "core/phase_plane/ceiling.h"

#include <algorithm>

#include "core/phase_plane/crossing.h"

namespace dualarm {
namespace {

/// Walks backwards from the goal, one stretch at a time.
class BackwardWalk {
 public:
  explicit BackwardWalk(const Path& path) : path_(path), limit_(path.energy_limit()), x_(path.length()) {}

  std::variant<std::vector<Stretch>, Blocked> run() {
    bool on_limit = false;
    double energy = 0.0;
    while (x_ > 0.0) {
      if (on_limit) {
        walk_along_limit();
        energy = limit_;
      } else if (!walk_along_braking(energy)) {
        return Blocked{BlockReason::kCannotBrake, path_.position(x_), 0.0, path_.extreme(ArcKind::kBrake)};
      }
      on_limit = !on_limit;
    }
    std::reverse(stretches_.begin(), stretches_.end());
    return stretches_;
  }

 private:
  /// Back along full braking until the velocity limit or the start. False if the energy is used up before.
  bool walk_along_braking(double energy) {
    Stretch stretch = {ArcKind::kBrake, 0.0, x_, x_, energy};
    const std::vector<double> cuts = path_.monotone_pieces(ArcKind::kBrake, 0.0, x_);
    for (std::size_t i = cuts.size() - 1; i > 0; --i) {
      const double energy_before = stretch.energy_at(path_, cuts[i - 1]);
      if (energy_before > limit_) {
        stretch.from = crossing([&](double x) { return stretch.energy_at(path_, x) - limit_; }, cuts[i - 1], cuts[i]);
        break;
      }
      if (energy_before <= 0.0) {
        x_ = crossing([&](double x) { return stretch.energy_at(path_, x); }, cuts[i - 1], cuts[i]);
        return false;
      }
    }
    push(stretch);
    return true;
  }

  /// Back along the velocity limit, as far as braking can hold it.
  void walk_along_limit() {
    Stretch stretch = {ArcKind::kCruise, 0.0, x_, x_, limit_};
    const std::vector<double> cuts = path_.monotone_pieces(ArcKind::kBrake, 0.0, x_);
    for (std::size_t i = cuts.size() - 1; i > 0; --i) {
      if (path_.acceleration(ArcKind::kBrake, 0.5 * (cuts[i - 1] + cuts[i])) > 0.0 &&
          path_.work_shows(ArcKind::kBrake, cuts[i], cuts[i - 1] - cuts[i], limit_)) {
        stretch.from = cuts[i];
        break;
      }
    }
    push(stretch);
  }

  void push(const Stretch& stretch) {
    if (stretch.from < stretch.to) stretches_.push_back(stretch);
    x_ = stretch.from;
  }

  const Path& path_;
  double limit_;
  double x_;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::variant<std::vector<Stretch>, Blocked> braking_ceiling(const Path& path) { return BackwardWalk(path).run(); }

}  // namespace dualarm

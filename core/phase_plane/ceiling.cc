#include "core/phase_plane/ceiling.h"

#include <iterator>

#include "core/phase_plane/limit_walk.h"

namespace dualarm {
namespace {

/// Walks backwards from the goal, one stretch at a time.
class BackwardWalk {
 public:
  BackwardWalk(const Path& path, double goal_energy) : path_(path), energy_(goal_energy), x_(path.length()) {}

  std::variant<std::vector<Stretch>, Obstruction> run() {
    bool on_limit = energy_ >= path_.energy_limit();
    while (x_ > 0.0) {
      if (on_limit) {
        push({std::nullopt, held_backward(path_, x_), x_});
        energy_ = path_.energy_limit();
        on_limit = false;
        continue;
      }
      const Extremal braking(path_, ArcKind::kBrake, x_, energy_, 0.0);
      if (braking.exit() == Extremal::Exit::kRest) return Obstruction{Obstruction::Kind::kCannotBrake, braking.end()};
      on_limit = braking.exit() == Extremal::Exit::kLimit;
      push({braking, braking.end(), x_});
    }
    return std::vector<Stretch>(std::make_move_iterator(stretches_.rbegin()),
                                std::make_move_iterator(stretches_.rend()));
  }

 private:
  void push(Stretch stretch) {
    x_ = stretch.from;
    if (stretch.from < stretch.to) stretches_.push_back(std::move(stretch));
  }

  const Path& path_;
  double energy_;
  double x_;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::variant<std::vector<Stretch>, Obstruction> braking_ceiling(const Path& path, double goal_energy) {
  return BackwardWalk(path, goal_energy).run();
}

}  // namespace dualarm

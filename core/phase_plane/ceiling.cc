#include "core/phase_plane/ceiling.h"

#include <iterator>

#include "core/phase_plane/limit_walk.h"

namespace dualarm {

BrakingWalk walk_back(const Path& path, double x, double energy) {
  BrakingWalk walk = {{}, x, false};
  const auto push = [&](Stretch stretch) {
    walk.end = stretch.from;
    if (stretch.from < stretch.to) walk.stretches.push_back(std::move(stretch));
  };
  bool on_limit = energy >= path.energy_limit();
  while (walk.end > 0.0 && !walk.from_rest) {
    if (on_limit) {
      push({std::nullopt, held_backward(path, walk.end), walk.end});
      energy = path.energy_limit();
      on_limit = false;
    } else {
      const Extremal braking(path, ArcKind::kBrake, walk.end, energy, 0.0);
      on_limit = braking.exit() == Extremal::Exit::kLimit;
      walk.from_rest = braking.exit() == Extremal::Exit::kRest;
      push({braking, braking.end(), walk.end});
    }
  }
  return walk;
}

std::variant<std::vector<Stretch>, Obstruction> braking_ceiling(const Path& path, double goal_energy) {
  BrakingWalk walk = walk_back(path, path.length(), goal_energy);
  if (walk.from_rest) return Obstruction{Obstruction::Kind::kCannotBrake, walk.end};
  return std::vector<Stretch>(std::make_move_iterator(walk.stretches.rbegin()),
                              std::make_move_iterator(walk.stretches.rend()));
}

}  // namespace dualarm

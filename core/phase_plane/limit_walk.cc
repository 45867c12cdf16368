#include "core/phase_plane/limit_walk.h"

#include <cmath>

namespace dualarm {
namespace {

/// Part of the limit's energy below which what an arc gains or loses does not show beside it: some thousand roundings.
/// Between two close sign changes of an acceleration the arc is then the velocity limit itself.
constexpr double kShowing = 1e-12;

/// Whether driving (or braking) from the limit at `from` to `to` departs from it visibly to the wrong side.
bool departs(const Path& path, ArcKind kind, double from, double to) {
  const double limit = path.energy_limit();
  const double middle = path.acceleration(kind, 0.5 * (from + to), limit);
  const bool is_wrong = kind == ArcKind::kAccelerate ? middle < 0.0 : middle > 0.0;
  return is_wrong && std::abs(middle * (to - from)) > kShowing * limit;
}

}  // namespace

double held_forward(const Path& path, double x, double until) {
  const std::vector<double> cuts = path.pieces(ArcKind::kAccelerate, path.energy_limit(), x, until);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (departs(path, ArcKind::kAccelerate, cuts[i], cuts[i + 1])) return cuts[i];
  }
  return until;
}

double held_backward(const Path& path, double x) {
  const std::vector<double> cuts = path.pieces(ArcKind::kBrake, path.energy_limit(), 0.0, x);
  for (std::size_t i = cuts.size() - 1; i > 0; --i) {
    if (departs(path, ArcKind::kBrake, cuts[i - 1], cuts[i])) return cuts[i];
  }
  return 0.0;
}

}  // namespace dualarm

#include "core/phase_plane/path.h"

#include <algorithm>

namespace dualarm {

std::vector<double> Path::between(const std::vector<double>& positions, double from, double to) const {
  std::vector<double> found;
  for (const double candidate : positions) {
    const double at = direction_ * (candidate - start_);
    if (from < at && at < to) found.push_back(at);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> Path::pieces(ArcKind kind, double energy, double from, double to) const {
  const auto [low, high] = std::minmax({position(from), position(to)});
  std::vector<double> cuts = between(system_->zeros(extreme(kind), velocity(energy), {low, high}), from, to);
  cuts.insert(cuts.begin(), from);
  cuts.push_back(to);
  return cuts;
}

std::vector<double> Path::bends(double from, double to) const {
  const auto [low, high] = std::minmax({position(from), position(to)});
  return between(system_->position_bends({low, high}), from, to);
}

}  // namespace dualarm

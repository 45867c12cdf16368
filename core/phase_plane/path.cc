#include "core/phase_plane/path.h"

#include <algorithm>
#include <cstddef>

namespace dualarm {

void Path::add_between(const std::vector<double>& positions, double from, double to, std::vector<double>& found) const {
  const auto first = static_cast<std::ptrdiff_t>(found.size());
  for (const double candidate : positions) {
    const double at = direction_ * (candidate - start_);
    if (from < at && at < to) found.push_back(at);
  }
  std::sort(found.begin() + first, found.end());
}

std::vector<double> Path::pieces(ArcKind kind, double energy, double from, double to) const {
  const auto [low, high] = std::minmax({position(from), position(to)});
  const std::vector<double> zeros = system_->zeros(extreme(kind), velocity(energy), {low, high});
  std::vector<double> cuts;
  cuts.reserve(zeros.size() + 2);
  cuts.push_back(from);
  add_between(zeros, from, to, cuts);
  cuts.push_back(to);
  return cuts;
}

std::vector<double> Path::bends(double from, double to) const {
  const auto [low, high] = std::minmax({position(from), position(to)});
  std::vector<double> found;
  add_between(system_->position_bends({low, high}), from, to, found);
  return found;
}

}  // namespace dualarm

#include "core/phase_plane/path.h"

#include <algorithm>

namespace dualarm {

std::vector<double> Path::monotone_pieces(ArcKind kind, double from, double to) const {
  const auto [low, high] = std::minmax({position(from), position(to)});
  std::vector<double> cuts = {from};
  for (const double zero : system_.zeros(extreme(kind), 0.0, {low, high})) {
    const double x = direction_ * (zero - start_);
    if (from < x && x < to) cuts.push_back(x);
  }
  cuts.push_back(to);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace dualarm

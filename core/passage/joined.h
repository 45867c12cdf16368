#pragma once

#include <utility>
#include <vector>

#include "core/phase_plane/profile.h"

namespace dualarm {

/// One motion after the other, which begins in the state in which the first ends.
inline Profile joined(const System& system, const Profile& before, const Profile& after) {
  std::vector<Arc> arcs = before.arcs();
  arcs.insert(arcs.end(), after.arcs().begin(), after.arcs().end());
  return arcs.empty() ? Profile(system, before.start_state()) : Profile(system, std::move(arcs));
}

}  // namespace dualarm

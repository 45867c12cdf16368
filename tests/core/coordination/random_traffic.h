#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/phase_plane/profile.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/problems.h"

namespace dualarm {

/// Two arms with their fastest motions, where there are any, and what moves around them.
struct TrafficScene {
  explicit TrafficScene(Problem from);

  double longest() const;        ///< s, of both motions
  double end_of_tracks() const;  ///< s

  Problem problem;
  std::array<SingleJointArm, kArmCount> systems;
  std::vector<Profile> motions;
};

/// A random problem with one to three objects on tracks, some of them turning, that visit where the arms pass or cross
/// their place; in some scenes the arms are out of each other's reach. Reproducible from its seed.
TrafficScene random_traffic_scene(std::uint64_t seed);

}  // namespace dualarm

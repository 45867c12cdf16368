#pragma once

#include <array>
#include <variant>
#include <vector>

#include "core/model/problem.h"
#include "core/verification/interpolant.h"
#include "core/verification/separation.h"
#include "geometry/chain.h"

namespace dualarm {

/// The joint that carries a body. The motion outlives this.
struct CarryingJoint {
  Base base;
  const Interpolant* motion = nullptr;
};

/// The ground, a joint or a track. The track outlives this.
using Carrier = std::variant<std::monostate, CarryingJoint, const PoseTrack*>;

/// A body and what carries it.
struct CarriedBody {
  Body body;  ///< in the frame of the link or of the track; in the world if it stands still
  Carrier carrier;
  double reach = 0.0;   ///< m, of its points from the axis about which it turns
  double extent = 0.0;  ///< m, of its points from the origin of its frame; from its own middle if it stands still
};

/// All bodies of a problem. Motions and problem outlive this.
struct CarriedBodies {
  std::array<std::vector<CarriedBody>, kArmCount> moving;  ///< with the arms
  std::vector<CarriedBody> fixed;
  std::vector<CarriedBody> tracked;
};

CarriedBodies carried_bodies(const Problem& problem, const std::array<Interpolant, kArmCount>& motions);

/// The shape in the world at a time (s).
Shape shape_at(const CarriedBody& body, double time);

/// Largest way (m) of any point of the body during an interval from where it is in the middle of it.
double farthest_way(const CarriedBody& body, Interval time);

/// Where an interval is best cut in two: in the middle, or at a corner of the body's track inside of it.
bool has_corner_inside(const CarriedBody& body, Interval time);
double cut_of(const CarriedBody& body, Interval time);

/// The time (s) of the last corner of all the bodies' tracks; minus infinity where none is on a track.
double last_corner(const std::vector<CarriedBody>& bodies);

/// Whether the joint that carries a body has come to rest by a time (s), to stay there.
bool stands_after(const CarriedBody& body, double time);

/// The body over an interval that has no corner inside.
TurningBody turning_body(const CarriedBody& body, Interval time);

}  // namespace dualarm

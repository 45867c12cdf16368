#pragma once

#include <limits>
#include <string_view>

namespace dualarm {

/// What a number on the wire may be; ends included. Infinite ends say that the infinity itself is allowed.
struct Range {
  double min;
  double max;
  std::string_view unit;

  constexpr bool contains(double value) const { return value >= min && value <= max; }  // NaN never is
};

/// The ranges of proto/dualarm/planning/v1, in one place. They are far wider than any robot: their work is to keep
/// sums, squares and quotients of the planner away from overflow and from the loss of every digit.
namespace ranges {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline constexpr Range kCoordinate = {-1e4, 1e4, "m"};
inline constexpr Range kAngle = {-1e3, 1e3, "rad"};
inline constexpr Range kLength = {1e-6, 1e4, "m"};
inline constexpr Range kSize = {0.0, 1e4, "m"};
inline constexpr Range kMass = {0.0, 1e9, "kg"};
inline constexpr Range kMomentOfInertia = {0.0, 1e15, "kg m^2"};
inline constexpr Range kTotalInertia = {1e-9, 1e18, "kg m^2"};
inline constexpr Range kFriction = {0.0, 1e12, "N m s"};
inline constexpr Range kGravity = {0.0, 1e3, "m/s^2"};
inline constexpr Range kFieldComponent = {-1e3, 1e3, "m/s^2"};
inline constexpr Range kTorque = {-1e12, 1e12, "N m"};
inline constexpr Range kStallTorque = {1e-12, 1e12, "N m"};
inline constexpr Range kNoLoadSpeed = {1e-9, 1e6, "rad/s"};
/// Slower limits are reached in so short a time that positions in double precision cannot show how.
inline constexpr Range kMinVelocity = {-kInfinity, -1e-4, "rad/s"};
inline constexpr Range kMaxVelocity = {1e-4, kInfinity, "rad/s"};
inline constexpr Range kVelocity = {-1e6, 1e6, "rad/s"};
inline constexpr Range kAccelerationScale = {1e-9, 1e9, "rad/s^2"};
inline constexpr Range kKnotPeriod = {1e-3, 10.0, "s"};
inline constexpr Range kStartDelay = {0.0, 1e6, "s"};
inline constexpr Range kTime = {-1e6, 1e6, "s"};
inline constexpr Range kResolution = {2.0, 2000.0, "points"};
inline constexpr Range kCurveResolution = {2.0, 10000.0, "points"};
inline constexpr Range kAny = {-1e300, 1e300, ""};

inline constexpr double kDefaultKnotPeriod = 0.01;   // s
inline constexpr int kDefaultResolution = 181;       // points along a joint range: one a degree of [0, pi]
inline constexpr int kDefaultCurveResolution = 361;  // points a curve: two a degree
inline constexpr int kMostListed = 16;               // tasks, methods: more are refused unread
inline constexpr int kLongestName = 64;              // characters

/// Most that friction and the slope of a drive's line may add up to, over the inertia (1/s), and the least speed
/// (rad/s) at which friction may use up the largest torque.
inline constexpr double kFastestDamping = 1e9;
inline constexpr double kLeastTopSpeed = 1e-9;

/// Most that a limit of a torque table may change with the velocity, over the inertia (1/s): a drive that is faster
/// than a millisecond is beyond what a controller plays and a plan's knots can show.
inline constexpr double kSteepestTable = 1e3;

/// s. Poses of a track are at least this far apart: a last digit of the largest times is 1e-10 s.
inline constexpr double kShortestStep = 1e-6;

/// rad. Two poses of a track that are turned against each other by half a revolution, less than this, have no shorter
/// way round that a client could rely on: room for the rounding of its angles.
inline constexpr double kHalfTurnRoom = 1e-6;

/// How far a mounting may depart from the paper's: room for the rounding of an angle such as pi (rad, m).
inline constexpr double kPlaneTolerance = 1e-9;

}  // namespace ranges
}  // namespace dualarm

#pragma once

namespace dualarm {

// What counts as equal, how tight proofs are made and when they end. Shares are of a limit: 1 is at the limit.

/// rad and rad/s. First and last knot against the task, position against the joint range, arcs against knots.
inline constexpr double kStateTolerance = 1e-7;

/// rad and rad/s, of all jumps of a motion together. Two knots at one time are the same state computed from either
/// side; rounding leaves far less, and many small jumps must not add up to a way that nobody checks.
inline constexpr double kJumpTolerance = 1e-9;

/// s. Knots at most this far apart, or a few last digits of their times, share a time (share_a_time): a quintic over
/// less is nothing but rounding.
inline constexpr double kSameTime = 1e-12;
inline constexpr double kSameTimeDigits = 4.0;

/// s. Knots that do not share a time are at least this far apart: over less, rounding hides what a motion does. Fastest
/// motions have arcs of 2e-9 s.
inline constexpr double kShortestPiece = 1e-11;

/// s. Ends of arcs against each other and against the plan: sums of times, each rounded.
inline constexpr double kTimeTolerance = 1e-9;

/// Share of the velocity limit. A cruise rides on the limit.
inline constexpr double kVelocityTolerance = 1e-6;

/// Share of the velocity limit, forgiven at most for rounding of knots: 5e-5 for pieces of 1e-6 s after a day.
inline constexpr double kMostVelocityRounding = 1e-4;

/// Share of a motion's largest velocity that rounding of accelerations may explain over all of its time. A piece of
/// 1e-6 s after 1e5 s takes 1.3e-4, usual ones nothing; without an end, many short pieces hide any acceleration.
inline constexpr double kMostForgivenVelocity = 2e-3;

/// Share of the torque limit. Fastest motions ride on the limit, and a quintic departs from them a little.
inline constexpr double kTorqueTolerance = 2e-6;

/// Share of the torque span (upper minus lower). Written torque against the torque that the motion needs.
inline constexpr double kTorqueColumnTolerance = 1e-6;

/// A proven peak exceeds the one that is attained by at most this part of the tolerance of its limit.
inline constexpr double kPeakSlack = 0.25;

/// Share of a torque limit by which a proven peak exceeds the attained one at most: what is reported of a fastest
/// motion is then within 1e-9 of 1. The search takes two to five times as long as for kPeakSlack.
inline constexpr double kTorquePeakSlack = 2e-10;

/// Times a piece between two knots is halved at most in search of a peak; what is then not proven counts as it is.
inline constexpr int kMostHalvings = 20;

/// The same where a piece crosses bends of torque limits: there the error of a bound falls with the interval only, not
/// with its square, but in few intervals. So these are counted too.
inline constexpr int kMostBendHalvings = 40;
inline constexpr int kMostIntervals = 1 << 13;

/// Share of a limit from which on the search of a peak no longer cares how much it is.
inline constexpr double kHopelessShare = 1e3;

/// m, and as a share of what is to spare: the proven smallest clearance is at most the larger of the two (and FCL's
/// error) below the smallest clearance seen.
inline constexpr double kClearanceResolution = 1e-6;
inline constexpr double kClearanceShare = 1e-4;

/// m. Bodies closer than this touch, and collide even where no clearance is demanded: bare segments that cross are at a
/// distance of 0, never below.
inline constexpr double kTouching = 1e-9;

/// s. Intervals of time are not split further: at 10 m/s nothing moves more than 1e-6 m meanwhile.
inline constexpr double kShortestInterval = 1e-7;

/// Distance queries in one verification, 0.05 s (0.5 s where numbers are huge or bodies are boxes and cylinders): a
/// bound on time against hostile trajectories. Good ones take some 20.
inline constexpr int kMostQueries = 50000;

/// Distance queries spent on better evidence after a collision is certain.
inline constexpr int kEvidenceQueries = 200;

/// m. Witness points closer than this give no direction to separate two bodies along.
inline constexpr double kShortestNormal = 1e-9;

/// m. Rounding in the separation of two bodies: 1e4 machine epsilons of 100 m.
inline constexpr double kSeparationRounding = 1e-10;

}  // namespace dualarm

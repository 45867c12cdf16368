#pragma once

#include <array>
#include <cstdint>

#include "core/model/problem.h"

namespace dualarm {

/// The dual arm of the worked values (theory, section 4): links of 6 m, bases 8 m apart, 1 kg, 3 kg m2 (39 kg m2 about
/// the joint), the paper's gravity with 9.81 m/s2, |torque| <= 60 N m, |velocity| <= 2 rad/s, range [0, pi]; arms
/// "arm1" at the origin and "arm2" facing it. From rest to rest, angles in degrees; radius and clearance in m.
Problem paper_problem(std::array<double, kArmCount> start_degrees, std::array<double, kArmCount> goal_degrees,
                      double radius = 0.0, double clearance = 0.0);

/// A problem of two planar arms that face each other, reproducible from its seed: lengths, masses, radii, limits,
/// clearance, base distance, placement in the world and its mirror image, all pairs of directions (also an arm that
/// stays), drives that can lift their arm everywhere and some that can not. Start and goal keep the clearance wherever
/// such were found in 200 tries.
Problem random_problem(std::uint64_t seed);

/// "simultaneous", "delay", "passage", "search".
const char* name_of(Method method);

/// Kinds of torque limits that problems are drawn with.
enum class DriveModel {
  kAsymmetric,       ///< constant, lower and upper far from each other
  kTorqueSpeedLine,  ///< of a drive
  kPositionTable,    ///< table with one velocity
  kVelocityTable,    ///< table with one position
  kTable,            ///< table over both
};

inline constexpr std::array<DriveModel, 5> kDriveModels = {DriveModel::kAsymmetric, DriveModel::kTorqueSpeedLine,
                                                           DriveModel::kPositionTable, DriveModel::kVelocityTable,
                                                           DriveModel::kTable};

const char* name_of(DriveModel model);

/// Torque limits of about `strength` (N m) at low speed, reproducible from their seed; zero lies inside of them
/// everywhere (at the no-load speed of a line, on them).
TorqueLimit random_torque_limit(std::uint64_t seed, DriveModel model, double strength);

/// The problem of a seed (the same arms, places and tasks) with other drives: torque limits of a model, about as strong
/// as the constant ones, and viscous friction that takes up to a tenth of them at 1 rad/s, or none.
Problem random_problem(std::uint64_t seed, DriveModel model, bool has_friction);

/// The same problem with end velocities (rad/s) drawn for both ends of both tasks, within the arms' velocity limits and
/// up to `fastest` either way; a quarter of them stays 0.
Problem with_moving_ends(Problem problem, std::uint64_t seed, double fastest);

}  // namespace dualarm

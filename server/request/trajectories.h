#pragma once

#include <array>

#include "core/model/trajectory.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

using TrajectoryMessages = google::protobuf::RepeatedPtrField<wire::ArmTrajectory>;

/// Trajectories in the order of the arms. A trajectory that is missing, doubled or of no arm of the robot is left for
/// the verifier to report; columns of unequal length, numbers that are not finite and more than one entry for each arm
/// are noted on `request`, which has the field `trajectories`.
Trajectory read_trajectories(const TrajectoryMessages& messages, const Field& request,
                             const std::array<Arm, kArmCount>& arms);

}  // namespace dualarm

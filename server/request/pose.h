#pragma once

#include "core/model/pose_track.h"
#include "server/request/field.h"
#include "server/wire.h"

namespace dualarm {

/// A place and an orientation; an absent pose is the identity. What is wrong is noted on `pose`.
Eigen::Isometry3d read_pose(const wire::Pose& message, const Field& pose);

/// A track through timed poses, or one that stands still where something is wrong, which is noted on `track`.
PoseTrack read_track(const wire::PoseTrack& message, const Field& track);

}  // namespace dualarm

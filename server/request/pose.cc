#include "server/request/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace dualarm {
namespace {

/// A pose of a track, or nothing where it says nothing that could be compared with others.
std::optional<TimedPose> read_timed_pose(const wire::TimedPose& message, const Field& field) {
  const double time = field.number("time_s", message.time_s(), ranges::kTime);
  if (!message.has_pose()) {
    field.complain_missing("pose", "give the object's pose in the world at that time");
    return std::nullopt;
  }
  const TimedPose pose = {time, read_pose(message.pose(), field.child("pose"))};
  if (!ranges::kTime.contains(time) || !pose.pose.matrix().allFinite()) return std::nullopt;
  return pose;
}

void check_step(const TimedPose& before, const TimedPose& after, const Field& field) {
  if (!(after.time - before.time >= ranges::kShortestStep)) {
    field.complain("time_s", fmt::format("is {} s, must be at least {} s after the pose before, which is at {} s",
                                         after.time, ranges::kShortestStep, before.time));
  }
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(before.pose.linear().transpose() * after.pose.linear()));
  if (turned.angle() > std::numbers::pi - ranges::kHalfTurnRoom) {
    field.complain("pose",
                   fmt::format("is turned by {} rad from the pose before: half a revolution has no shorter way round, "
                               "give a pose in between",
                               turned.angle()));
  }
}

}  // namespace

Eigen::Isometry3d read_pose(const wire::Pose& message, const Field& field) {
  const Eigen::Vector3d origin = {field.number("x_m", message.x_m(), ranges::kCoordinate),
                                  field.number("y_m", message.y_m(), ranges::kCoordinate),
                                  field.number("z_m", message.z_m(), ranges::kCoordinate)};
  const double roll = field.number("roll_rad", message.roll_rad(), ranges::kAngle);
  const double pitch = field.number("pitch_rad", message.pitch_rad(), ranges::kAngle);
  const double yaw = field.number("yaw_rad", message.yaw_rad(), ranges::kAngle);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  pose.translation() = origin;
  return pose;
}

PoseTrack read_track(const wire::PoseTrack& message, const Field& track) {
  const int count = message.poses_size();
  if (count == 0) {
    track.complain_missing("poses", "give at least one");
    return {};
  }
  if (count > track.limits().poses) {
    track.complain("poses", fmt::format("has {} entries, must have at most {}", count, track.limits().poses));
    return {};
  }
  std::vector<TimedPose> poses;
  bool is_whole = true;
  std::optional<TimedPose> before;
  for (int i = 0; i < count; ++i) {
    const Field field = track.child("poses", i);
    const std::optional<TimedPose> pose = read_timed_pose(message.poses(i), field);
    if (pose && before) check_step(*before, *pose, field);
    is_whole = is_whole && pose && (!before || pose->time > before->time);
    if (is_whole) poses.push_back(*pose);
    before = pose;
  }
  return is_whole ? PoseTrack(std::move(poses)) : PoseTrack();
}

}  // namespace dualarm

#include "server/request/trajectories.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "server/request/robot.h"

namespace dualarm {
namespace {

using Column = google::protobuf::RepeatedField<double>;

void check_column(const Column& column, std::string_view name, int length, const Field& knots) {
  if (column.size() != length) {
    knots.complain(name, fmt::format("has {} entries, must have {} as time_s has", column.size(), length));
    return;
  }
  for (int k = 0; k < length; ++k) {
    if (std::abs(column[k]) <= ranges::kAny.max) continue;
    knots.complain(fmt::format("{}[{}]", name, k), fmt::format("is {}, must be finite", column[k]));
    return;  // one a column says enough
  }
}

std::vector<Knot> read_knots(const wire::Knots& message, const Field& field) {
  const int length = message.time_s_size();
  if (length > field.limits().knots) {
    field.complain("time_s", fmt::format("has {} entries, must have at most {}", length, field.limits().knots));
    return {};
  }
  check_column(message.time_s(), "time_s", length, field);
  check_column(message.position_rad(), "position_rad", length, field);
  check_column(message.velocity_rad_per_s(), "velocity_rad_per_s", length, field);
  check_column(message.acceleration_rad_per_s2(), "acceleration_rad_per_s2", length, field);
  check_column(message.torque_newton_meters(), "torque_newton_meters", length, field);
  const int shortest = std::min({length, message.position_rad_size(), message.velocity_rad_per_s_size(),
                                 message.acceleration_rad_per_s2_size(), message.torque_newton_meters_size()});
  std::vector<Knot> knots(shortest);
  for (int k = 0; k < shortest; ++k) {
    knots[k] = {message.time_s(k), message.position_rad(k), message.velocity_rad_per_s(k),
                message.acceleration_rad_per_s2(k), message.torque_newton_meters(k)};
  }
  return knots;
}

ArcKind read_arc_kind(wire::ArcKind kind, const Field& arc) {
  switch (kind) {
    case wire::ARC_KIND_ACCELERATE:
      return ArcKind::kAccelerate;
    case wire::ARC_KIND_BRAKE:
      return ArcKind::kBrake;
    case wire::ARC_KIND_CRUISE:
      return ArcKind::kCruise;
    case wire::ARC_KIND_HOLD:
      return ArcKind::kHold;
    default:
      arc.complain("kind", fmt::format("is {}, must be ARC_KIND_ACCELERATE, ARC_KIND_BRAKE, ARC_KIND_CRUISE or "
                                       "ARC_KIND_HOLD",
                                       static_cast<int>(kind)));
      return ArcKind::kHold;
  }
}

JointState read_arc_state(const wire::JointState& message, const Field& field) {
  return {field.number("position_rad", message.position_rad(), ranges::kAny),
          field.number("velocity_rad_per_s", message.velocity_rad_per_s(), ranges::kAny)};
}

Arc read_arc(const wire::Arc& message, const Field& field) {
  return {read_arc_kind(message.kind(), field), field.number("start_time_s", message.start_time_s(), ranges::kAny),
          field.number("end_time_s", message.end_time_s(), ranges::kAny),
          read_arc_state(message.start(), field.child("start")), read_arc_state(message.end(), field.child("end"))};
}

ArmTrajectory read_trajectory(const wire::ArmTrajectory& message, const Field& field) {
  ArmTrajectory trajectory;
  trajectory.arm = message.arm();
  trajectory.start_time = field.number("start_time_s", message.start_time_s(), ranges::kAny);
  trajectory.duration = field.number("duration_s", message.duration_s(), ranges::kAny);
  if (message.arcs_size() > field.limits().knots) {
    field.complain("arcs",
                   fmt::format("has {} entries, must have at most {}", message.arcs_size(), field.limits().knots));
  } else {
    for (int i = 0; i < message.arcs_size(); ++i) {
      trajectory.arcs.push_back(read_arc(message.arcs(i), field.child("arcs", i)));
    }
  }
  trajectory.knots = read_knots(message.knots(), field.child("knots"));
  return trajectory;
}

}  // namespace

Trajectory read_trajectories(const TrajectoryMessages& messages, const Field& request,
                             const std::array<Arm, kArmCount>& arms) {
  if (messages.size() > kArmCount) {
    request.complain("trajectories",
                     fmt::format("has {} entries, must have one for each of the {} arms", messages.size(), kArmCount));
    return {};
  }
  std::array<std::optional<ArmTrajectory>, kArmCount> placed;
  std::vector<ArmTrajectory> left_over;
  for (int i = 0; i < messages.size(); ++i) {
    ArmTrajectory trajectory = read_trajectory(messages[i], request.child("trajectories", i));
    const int arm = index_of(arms, trajectory.arm);
    if (arm >= 0 && !placed[arm]) {
      placed[arm] = std::move(trajectory);
    } else {
      left_over.push_back(std::move(trajectory));
    }
  }
  Trajectory ordered;
  for (int arm = 0; arm < kArmCount; ++arm) {
    if (placed[arm]) {
      ordered[arm] = *std::move(placed[arm]);
    } else if (!left_over.empty()) {
      ordered[arm] = std::move(left_over.back());
      left_over.pop_back();
    }
  }
  return ordered;
}

}  // namespace dualarm

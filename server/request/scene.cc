#include "server/request/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "server/request/arm.h"
#include "server/request/robot.h"

namespace dualarm {
namespace {

using Arms = std::array<Arm, kArmCount>;
using Placement = decltype(Object::placement);

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

Capsule read_shape(const wire::Object& message, const Field& field) {
  switch (message.shape_case()) {
    case wire::Object::kSphere: {
      const double radius = field.child("sphere").number("radius_m", message.sphere().radius_m(), ranges::kSize);
      return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), radius};
    }
    case wire::Object::kCapsule: {
      const Field capsule = field.child("capsule");
      const double half = 0.5 * capsule.number("length_m", message.capsule().length_m(), ranges::kSize);
      const double radius = capsule.number("radius_m", message.capsule().radius_m(), ranges::kSize);
      return {{-half, 0.0, 0.0}, {half, 0.0, 0.0}, radius};
    }
    case wire::Object::kBox:
      field.complain_not_served("box", "give a capsule that contains it");
      break;
    case wire::Object::kCylinder:
      field.complain_not_served("cylinder", "give a capsule that contains it");
      break;
    case wire::Object::SHAPE_NOT_SET:
      field.complain_missing("shape", "give a sphere or a capsule");
  }
  return {};
}

AttachedPlacement read_attachment(const wire::Attachment& message, const Field& field, const Arms& arms) {
  AttachedPlacement placement;
  placement.arm = index_of(arms, message.arm());
  if (placement.arm < 0 && has_names(arms)) {
    field.complain("arm", fmt::format("is {}, must be {}", quoted(message.arm()), names_of(arms)));
  }
  placement.pose_in_link = read_pose(message.pose_in_link(), field.child("pose_in_link"));
  placement.mass = field.number("mass_kg", message.mass_kg(), ranges::kMass);
  return placement;
}

// Distances of planar capsules have a closed form; a capsule that leans out of the plane has none yet.
void check_in_plane(const Capsule& shape, const Eigen::Isometry3d& pose, const Field& field) {
  const Eigen::Vector3d axis = pose.linear() * (shape.end - shape.start);
  if (!(std::abs(axis.z()) > ranges::kPlaneTolerance * axis.norm())) return;
  field.complain("pitch_rad",
                 "leans the capsule's axis out of the plane of motion, which is not served by this version: "
                 "keep the axis parallel to the world's x-y plane, or give a sphere");
}

Placement read_placement(const wire::Object& message, const Field& field, const Arms& arms, const Capsule& shape) {
  switch (message.placement_case()) {
    case wire::Object::kFixed: {
      const FixedPlacement fixed = {read_pose(message.fixed(), field.child("fixed"))};
      check_in_plane(shape, fixed.pose, field.child("fixed"));
      return fixed;
    }
    case wire::Object::kAttached: {
      const AttachedPlacement attached = read_attachment(message.attached(), field.child("attached"), arms);
      check_in_plane(shape, attached.pose_in_link, field.child("attached").child("pose_in_link"));
      return attached;
    }
    case wire::Object::kMoving:
      field.complain_not_served("moving", "give fixed objects that cover where it can be");
      break;
    case wire::Object::PLACEMENT_NOT_SET:
      field.complain_missing("placement", "give fixed or attached");
  }
  return {};
}

}  // namespace

std::vector<Object> read_scene(const wire::Scene& message, const Field& scene, const Arms& arms) {
  if (message.objects_size() > ranges::kMostObjects) {
    scene.complain("objects",
                   fmt::format("has {} entries, must have at most {}", message.objects_size(), ranges::kMostObjects));
    return {};
  }
  std::vector<Object> objects;
  std::set<std::string_view> taken = {arms[0].name, arms[1].name};
  for (int i = 0; i < message.objects_size(); ++i) {
    const wire::Object& object = message.objects(i);
    const Field field = scene.child("objects", i);
    read_name(object.name(), field);
    if (!object.name().empty() && !taken.insert(object.name()).second) {
      field.complain("name", fmt::format("is {}, which another object or an arm has already", quoted(object.name())));
    }
    const Capsule shape = read_shape(object, field);
    objects.push_back({object.name(), shape, read_placement(object, field, arms, shape)});
  }
  return objects;
}

}  // namespace dualarm

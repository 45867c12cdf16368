#include "server/request/shape.h"

#include <fmt/format.h>

namespace dualarm {
namespace {

Capsule read_capsule(const wire::Capsule& message, const Field& capsule) {
  const double half = 0.5 * capsule.number("length_m", message.length_m(), ranges::kSize);
  const double radius = capsule.number("radius_m", message.radius_m(), ranges::kSize);
  return {{-half, 0.0, 0.0}, {half, 0.0, 0.0}, radius};
}

Box read_box(const wire::Box& message, const Field& box) {
  const Eigen::Vector3d size = {box.number("size_x_m", message.size_x_m(), ranges::kSize),
                                box.number("size_y_m", message.size_y_m(), ranges::kSize),
                                box.number("size_z_m", message.size_z_m(), ranges::kSize)};
  return {Eigen::Isometry3d::Identity(), 0.5 * size};
}

Cylinder read_cylinder(const wire::Cylinder& message, const Field& cylinder) {
  static_assert(ranges::kLength.min >= kShortestCylinder);
  const double length = message.length_m();
  if (ranges::kSize.contains(length) && !ranges::kLength.contains(length)) {
    cylinder.complain("length_m", fmt::format("is {}, must be {} to {} m: a disc needs some thickness, else give a box",
                                              length, ranges::kLength.min, ranges::kLength.max));
  } else {
    cylinder.number("length_m", length, ranges::kLength);
  }
  const double radius = cylinder.number("radius_m", message.radius_m(), ranges::kSize);
  return {{-0.5 * length, 0.0, 0.0}, {0.5 * length, 0.0, 0.0}, radius};
}

}  // namespace

Shape read_shape(const wire::Object& message, const Field& object) {
  switch (message.shape_case()) {
    case wire::Object::kSphere: {
      const double radius = object.child("sphere").number("radius_m", message.sphere().radius_m(), ranges::kSize);
      return Capsule{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), radius};
    }
    case wire::Object::kCapsule:
      return read_capsule(message.capsule(), object.child("capsule"));
    case wire::Object::kBox:
      return read_box(message.box(), object.child("box"));
    case wire::Object::kCylinder:
      return read_cylinder(message.cylinder(), object.child("cylinder"));
    case wire::Object::SHAPE_NOT_SET:
      object.complain_missing("shape", "give a sphere, a capsule, a box or a cylinder");
  }
  return {};
}

}  // namespace dualarm

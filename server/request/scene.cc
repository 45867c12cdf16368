#include "server/request/scene.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "server/request/arm.h"
#include "server/request/pose.h"
#include "server/request/robot.h"
#include "server/request/shape.h"

namespace dualarm {
namespace {

using Arms = std::array<Arm, kArmCount>;
using Placement = decltype(Object::placement);

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

Placement read_placement(const wire::Object& message, const Field& field, const Arms& arms) {
  switch (message.placement_case()) {
    case wire::Object::kFixed:
      return FixedPlacement{read_pose(message.fixed(), field.child("fixed"))};
    case wire::Object::kAttached:
      return read_attachment(message.attached(), field.child("attached"), arms);
    case wire::Object::kMoving:
      return MovingPlacement{read_track(message.moving(), field.child("moving"))};
    case wire::Object::PLACEMENT_NOT_SET:
      field.complain_missing("placement", "give fixed, attached or moving");
  }
  return {};
}

}  // namespace

std::vector<Object> read_scene(const wire::Scene& message, const Field& scene, const Arms& arms) {
  if (message.objects_size() > scene.limits().objects) {
    scene.complain("objects",
                   fmt::format("has {} entries, must have at most {}", message.objects_size(), scene.limits().objects));
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
    Shape shape = read_shape(object, field);
    objects.push_back({object.name(), std::move(shape), read_placement(object, field, arms)});
  }
  return objects;
}

}  // namespace dualarm

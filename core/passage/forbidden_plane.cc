#include "core/passage/forbidden_plane.h"

#include <utility>
#include <vector>

#include "core/coordination/upright.h"

namespace dualarm {
namespace {

bool leans(const Problem& problem, const Object& object) {
  const auto* attached = std::get_if<AttachedPlacement>(&object.placement);
  if (attached == nullptr) return false;
  for (const Body& body : moving_bodies(problem, attached->arm)) {
    if (body.name == object.name && !upright(body.shape)) return true;
  }
  return false;
}

/// The scene without what is not sliced in closed form, and the exact set of the rest: a part of what is forbidden.
Problem exactly_sliced(const Problem& problem) {
  Problem exact = problem;
  exact.options.region_model = RegionModel::kExact;
  std::erase_if(exact.objects, [&](const Object& object) { return leans(problem, object); });
  return exact;
}

/// The same scene with the arms' names for each other exchanged.
Problem exchanged(Problem problem) {
  std::swap(problem.arms[0], problem.arms[1]);
  std::swap(problem.tasks[0], problem.tasks[1]);
  for (Object& object : problem.objects) {
    if (auto* attached = std::get_if<AttachedPlacement>(&object.placement)) attached->arm = 1 - attached->arm;
  }
  return problem;
}

}  // namespace

bool cross(const Slice& first, const Slice& second) {
  return first.pinned_arm != second.pinned_arm && first.forbidden.contains(second.position) &&
         second.forbidden.contains(first.position);
}

ForbiddenPlane::ForbiddenPlane(const Problem& problem, double clearance)
    : ranges_{problem.arms[0].joint_range, problem.arms[1].joint_range},
      sets_{ForbiddenSet(exactly_sliced(problem), clearance),
            ForbiddenSet(exchanged(exactly_sliced(problem)), clearance)} {}

IntervalSet ForbiddenPlane::slice(int pinned_arm, double position) const {
  return sets_[pinned_arm].slice(position, ranges_[1 - pinned_arm]);
}

std::optional<Slice> ForbiddenPlane::slice_through(int pinned_arm, double position, double through) const {
  for (const Interval& stretch : slice(pinned_arm, position).intervals()) {
    if (stretch.contains(through)) return Slice{pinned_arm, position, stretch};
  }
  return std::nullopt;
}

}  // namespace dualarm

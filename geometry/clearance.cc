#include "geometry/clearance.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>

#include "geometry/nearest_points.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

// m. FCL decides "parallel" by an absolute threshold (2e-14 m2 on the product of both lengths and the sine between
// them), so that an axis of length a may cost 2e-14 / a of accuracy. A shorter axis than this is judged as its
// midpoint.
constexpr double kShortestAxis = 1e-7;

// m. Half the shortest axis, or what the threshold costs at the shortest axis, whichever is more, with room to spare.
constexpr double kFloorOfError = 3e-7;

// m per m of the longer axis. FCL solves 2 x 2 equations whose determinant drowns in rounding when the angle between
// the axes falls below the square root of the machine's precision (1.5e-8); the test measures 2e-8 at worst.
constexpr double kErrorPerLength = 4e-8;

// GJK stops when a step gains less than this, of the size of the scene. FCL's own 1e-6 costs up to 3.5e-2 m.
constexpr double kGjkTolerance = 1e-12;

// How far FCL's distance may be above what is proven about it, m per m of the scene: more than rounding, less than
// anybody will notice.
constexpr double kProvenGap = 1e-10;

// m. Rounding of coordinates of up to 10 km in the plane that proves a distance (some 1e-11 m), with room to spare.
constexpr double kFloorOfRounding = 1e-9;

// m per m of either body, the same for its size.
constexpr double kRoundingPerLength = 1e-14;

// m. What rounding of such coordinates moves the ends of a cylinder's axis, both together. A wafer leans with it.
constexpr double kRoundingOfAxis = 1e-11;

double axis_length(const Capsule& capsule) { return (capsule.end - capsule.start).norm(); }

/// What is left of a shape without its rounding: all points within `radius` of the core are the shape. A capsule as a
/// core has radius 0; a plate is a box, whatever is thinner is a segment or a point.
struct Core {
  Shape shape;
  double radius = 0.0;
};

struct CoreOf {
  Core operator()(const Capsule& capsule) const { return {Capsule{capsule.start, capsule.end, 0.0}, capsule.radius}; }
  Core operator()(const Box& box) const {
    if ((box.half_extents.array() > 0.0).count() > 1) return {box, 0.0};
    return {Capsule{box.pose * box.half_extents, box.pose * Eigen::Vector3d(-box.half_extents), 0.0}, 0.0};
  }
  Core operator()(const Cylinder& cylinder) const {
    if (cylinder.radius == 0.0) return {Capsule{cylinder.start, cylinder.end, 0.0}, 0.0};
    if ((cylinder.end - cylinder.start).norm() >= kShortestCylinder) return {cylinder, 0.0};
    return {Capsule{centre(cylinder), centre(cylinder), 0.0}, bounding_radius(cylinder)};
  }
};

Core core_of(const Shape& shape) { return std::visit(CoreOf{}, shape); }

const Capsule* axis_of(const Core& core) { return std::get_if<Capsule>(&core.shape); }

/// Seen from `origin`.
Shape shifted(const Shape& shape, const Eigen::Vector3d& origin) {
  struct Shifted {
    const Eigen::Vector3d& origin;
    Shape operator()(const Capsule& capsule) const {
      return Capsule{capsule.start - origin, capsule.end - origin, capsule.radius};
    }
    Shape operator()(Box box) const {
      box.pose.translation() -= origin;
      return box;
    }
    Shape operator()(const Cylinder& cylinder) const {
      return Cylinder{cylinder.start - origin, cylinder.end - origin, cylinder.radius};
    }
  };
  return std::visit(Shifted{origin}, shape);
}

/// FCL's shapes lie centred in their own frame, along z if they have an axis; lengths do not count round caps.
struct FclBody {
  std::variant<fcl::Sphered, fcl::Capsuled, fcl::Boxd, fcl::Cylinderd> shape;
  fcl::Transform3d pose;

  const fcl::CollisionGeometryd* geometry() const {
    return std::visit([](const auto& kind) -> const fcl::CollisionGeometryd* { return &kind; }, shape);
  }
};

fcl::Transform3d pose_of_axis(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = 0.5 * (start + end);
  const double length = (end - start).norm();
  if (length == 0.0) return pose;
  const Eigen::Vector3d z = (end - start) / length;
  const Eigen::Vector3d x = z.unitOrthogonal();
  pose.linear() << x, z.cross(x), z;
  return pose;
}

/// `scale` times as large.
struct ToFcl {
  double scale = 1.0;

  FclBody operator()(const Capsule& capsule) const {
    const double length = scale * axis_length(capsule);
    const fcl::Transform3d pose = pose_of_axis(scale * capsule.start, scale * capsule.end);
    if (length == 0.0) return {fcl::Sphered(scale * capsule.radius), pose};
    return {fcl::Capsuled(scale * capsule.radius, length), pose};
  }
  FclBody operator()(const Box& box) const {
    fcl::Transform3d pose = box.pose;
    pose.translation() *= scale;
    return {fcl::Boxd(Eigen::Vector3d(2.0 * scale * box.half_extents)), pose};
  }
  FclBody operator()(const Cylinder& cylinder) const {
    return {fcl::Cylinderd(scale * cylinder.radius, scale * (cylinder.end - cylinder.start).norm()),
            pose_of_axis(scale * cylinder.start, scale * cylinder.end)};
  }
};

/// FCL's distance, not positive where it sees an overlap. Never signed: FCL 0.7 then leaves the closed form of capsules
/// and aborts the process on some touching pairs. Never its default solver either, which asserts that it has not lost
/// its way and aborts on one in some hundred pairs of cylinders; FCL's own GJK knows no assertions.
Clearance ask_fcl(const FclBody& first, const FclBody& second) {
  fcl::DistanceRequestd request(/*enable_nearest_points=*/true);
  request.gjk_solver_type = fcl::GST_INDEP;
  request.distance_tolerance = kGjkTolerance;
  fcl::DistanceResultd result;
  fcl::distance(first.geometry(), first.pose, second.geometry(), second.pose, request, result);
  return {result.min_distance, result.nearest_points[0], result.nearest_points[1]};
}

/// A power of two (m), so that scaling by it rounds nothing, about the size of the scene seen from the first's centre.
double scene_size(const Shape& first, const Shape& second) {
  const double size = bounding_radius(first) + bounding_radius(second) + (centre(first) - centre(second)).norm();
  return std::exp2(std::ceil(std::log2(size)));
}

/// Nearest points of two cores near the origin. FCL's, which it finds in a scene of one metre because of its absolute
/// thresholds, are taken where a plane across them proves their distance.
NearestPoints proven_points(const Shape& first, const Shape& second) {
  const double size = scene_size(first, second);
  const ToFcl to_fcl = {1.0 / size};
  const Clearance found = ask_fcl(std::visit(to_fcl, first), std::visit(to_fcl, second));
  const double distance = size * found.distance;
  Eigen::Vector3d across = found.point_on_first - found.point_on_second;
  if (distance > 0.0 && across.norm() > 0.0) {
    const double proven = separation(first, second, across);
    if (distance - proven <= kProvenGap * size) {
      return {size * found.point_on_first, size * found.point_on_second, std::min(distance, proven)};
    }
  } else {
    across = centre(first) - centre(second);
  }
  return nearest_points(first, second, across.norm() > 0.0 ? across : Eigen::Vector3d::UnitX(), size);
}

Clearance clearance_of_cores(const Core& first, const Core& second) {
  const Eigen::Vector3d origin = centre(first.shape);
  const NearestPoints found = proven_points(shifted(first.shape, origin), shifted(second.shape, origin));
  const Eigen::Vector3d across = found.on_first - found.on_second;
  const Eigen::Vector3d normal = across.norm() > 0.0 ? across.normalized() : across;
  return {found.lower_bound - first.radius - second.radius, origin + found.on_first - first.radius * normal,
          origin + found.on_second + second.radius * normal};
}

/// How far (m) rounding of its axis moves the rim of a cylinder.
double rounding_of_rim(const Shape& core) {
  const auto* cylinder = std::get_if<Cylinder>(&core);
  if (cylinder == nullptr) return 0.0;
  return kRoundingOfAxis * cylinder->radius / (cylinder->end - cylinder->start).norm();
}

/// Of FCL's distance of capsules.
double error_of_axes(const Capsule& first, const Capsule& second) {
  return kFloorOfError + kErrorPerLength * std::max(axis_length(first), axis_length(second));
}

}  // namespace

Clearance clearance(const Capsule& first, const Capsule& second) {
  const auto without_speck = [](const Capsule& capsule) -> FclBody {
    const double length = axis_length(capsule);
    if (length >= kShortestAxis) return ToFcl()(capsule);
    const Eigen::Vector3d middle = 0.5 * (capsule.start + capsule.end);
    return {fcl::Capsuled(capsule.radius, 0.0), pose_of_axis(middle, middle)};
  };
  return ask_fcl(without_speck(first), without_speck(second));
}

Clearance clearance(const Shape& first, const Shape& second) {
  const auto* first_capsule = std::get_if<Capsule>(&first);
  const auto* second_capsule = std::get_if<Capsule>(&second);
  if (first_capsule != nullptr && second_capsule != nullptr) return clearance(*first_capsule, *second_capsule);
  const Core a = core_of(first);
  const Core b = core_of(second);
  if (axis_of(a) == nullptr || axis_of(b) == nullptr) return clearance_of_cores(a, b);
  return clearance(Capsule{axis_of(a)->start, axis_of(a)->end, a.radius},
                   Capsule{axis_of(b)->start, axis_of(b)->end, b.radius});
}

double clearance_error(const Shape& first, const Shape& second) {
  const auto* first_capsule = std::get_if<Capsule>(&first);
  const auto* second_capsule = std::get_if<Capsule>(&second);
  if (first_capsule != nullptr && second_capsule != nullptr) return error_of_axes(*first_capsule, *second_capsule);
  const Core a = core_of(first);
  const Core b = core_of(second);
  if (axis_of(a) == nullptr || axis_of(b) == nullptr) {
    return kFloorOfRounding + kRoundingPerLength * (bounding_radius(first) + bounding_radius(second)) +
           rounding_of_rim(a.shape) + rounding_of_rim(b.shape);
  }
  return error_of_axes(*axis_of(a), *axis_of(b));
}

}  // namespace dualarm

#include "core/model/payload_inertia.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "geometry/chain.h"
#include "tests/support/dice.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMass = 3.0;

template <typename Function>
double integral(double low, double high, const Function& function) {
  return boost::math::quadrature::gauss<double, 15>::integrate(function, low, high);
}

/// Volume, and integral of x^2 + y^2 in the link frame.
struct Moments {
  double volume = 0.0;
  double second = 0.0;
};

/// A body of revolution about an axis through `centre`, `radius_at` metres wide at each place between the bounds. Caps
/// are polynomials too, because only the square of the radius is integrated; eight points do for the angle.
template <typename Radius>
void add_revolved(Moments& sum, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double low, double high,
                  const Radius& radius_at) {
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  sum.volume += integral(low, high, [&](double z) { return kPi * radius_at(z) * radius_at(z); });
  sum.second += integral(low, high, [&](double z) {
    return integral(0.0, radius_at(z), [&](double r) {
      double ring = 0.0;
      for (int i = 0; i < 8; ++i) {
        const double angle = 0.25 * kPi * i;
        const Eigen::Vector3d point = centre + z * axis + r * (std::cos(angle) * u + std::sin(angle) * v);
        ring += point.head<2>().squaredNorm() / 8.0;
      }
      return 2.0 * kPi * r * ring;
    });
  });
}

double integrated(const Capsule& capsule) {
  const Eigen::Vector3d centre = 0.5 * (capsule.start + capsule.end);
  const double half = 0.5 * (capsule.end - capsule.start).norm();
  const Eigen::Vector3d axis = half > 0.0 ? Eigen::Vector3d((capsule.end - centre) / half) : Eigen::Vector3d::UnitX();
  Moments sum;
  const double r = capsule.radius;
  add_revolved(sum, centre, axis, -half, half, [&](double) { return r; });
  for (const double side : {-1.0, 1.0}) {
    add_revolved(sum, centre + side * half * axis, side * axis, 0.0, r,
                 [&](double z) { return std::sqrt(std::max(0.0, r * r - z * z)); });
  }
  return kMass * sum.second / sum.volume;
}

double integrated(const Cylinder& cylinder) {
  const Eigen::Vector3d centre = 0.5 * (cylinder.start + cylinder.end);
  const double half = 0.5 * (cylinder.end - cylinder.start).norm();
  Moments sum;
  add_revolved(sum, centre, (cylinder.end - centre) / half, -half, half, [&](double) { return cylinder.radius; });
  return kMass * sum.second / sum.volume;
}

double integrated(const Box& box) {
  const Eigen::Vector3d h = box.half_extents;
  const double second = integral(-h.x(), h.x(), [&](double x) {
    return integral(-h.y(), h.y(), [&](double y) {
      return integral(-h.z(), h.z(),
                      [&](double z) { return (box.pose * Eigen::Vector3d(x, y, z)).head<2>().squaredNorm(); });
    });
  });
  return kMass * second / (8.0 * h.prod());
}

Eigen::Isometry3d random_pose(Dice& dice) {
  const Eigen::Vector3d axis(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
  return Eigen::Translation3d(dice.between(-2.0, 2.0), dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)) *
         Eigen::AngleAxisd(dice.between(0.0, kPi), axis.normalized());
}

TEST(PayloadInertia, IsTheIntegralOverTheSolidWhereverItIs) {
  constexpr std::uint64_t kSeed = 67;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Isometry3d pose = random_pose(dice);
    const Eigen::Vector3d half(dice.between(0.01, 1.0), 0.0, 0.0);
    const double radius = dice.between(0.01, 1.0);
    const Capsule capsule = {pose * half, pose * Eigen::Vector3d(-half), radius};
    EXPECT_NEAR(payload_inertia(capsule, kMass), integrated(capsule), 1e-9 * integrated(capsule));
    const Cylinder cylinder = {capsule.start, capsule.end, radius};
    EXPECT_NEAR(payload_inertia(cylinder, kMass), integrated(cylinder), 1e-9 * integrated(cylinder));
    const Box box = {pose, {dice.between(0.01, 1.0), dice.between(0.01, 1.0), dice.between(0.01, 1.0)}};
    EXPECT_NEAR(payload_inertia(box, kMass), integrated(box), 1e-9 * integrated(box));
  }
}

TEST(PayloadInertia, OfTextbookBodiesAboutTheirOwnCentre) {
  EXPECT_DOUBLE_EQ(payload_inertia(Capsule{{0, 0, 0}, {0, 0, 0}, 0.5}, kMass), 0.4 * kMass * 0.25);
  EXPECT_DOUBLE_EQ(payload_inertia(Capsule{{-1, 0, 0}, {1, 0, 0}, 0.0}, kMass), kMass * 4.0 / 12.0);
  EXPECT_DOUBLE_EQ(payload_inertia(Cylinder{{0, 0, -1}, {0, 0, 1}, 0.5}, kMass), 0.5 * kMass * 0.25);
  EXPECT_DOUBLE_EQ(payload_inertia(Cylinder{{0, 0, 0}, {0, 0, 0}, 0.0}, kMass), 0.0);
  Box plate;
  plate.half_extents = {1.0, 2.0, 0.0};
  EXPECT_DOUBLE_EQ(payload_inertia(plate, kMass), kMass * (4.0 + 16.0) / 12.0);
}

TEST(PayloadInertia, GrowsWithTheSquareOfTheDistanceFromTheJointAndNotWithTheHeight) {
  const Capsule ball = {{3.0, 4.0, 7.0}, {3.0, 4.0, 7.0}, 0.5};
  EXPECT_DOUBLE_EQ(payload_inertia(ball, kMass), kMass * (0.4 * 0.25 + 25.0));
}

TEST(PayloadInertia, OfNoMassIsNone) { EXPECT_EQ(payload_inertia(Box{}, 0.0), 0.0); }

}  // namespace
}  // namespace dualarm

#include "geometry/motion_bound.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/chain.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

TEST(MotionBound, ALinkReachesItsLengthAndRadius) {
  EXPECT_DOUBLE_EQ(reach(Capsule{{0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, 0.25}), 6.25);
}

TEST(MotionBound, TheNearEndMayBeTheFarOne) { EXPECT_DOUBLE_EQ(reach(Capsule{{3.0, 4.0, 0.0}, {1.0, 0.0, 0.0}, 0.5}), 5.5); }

TEST(MotionBound, HeightAboveThePlaneAddsNothing) {
  EXPECT_DOUBLE_EQ(reach(Capsule{{3.0, 4.0, 7.0}, {0.0, 0.0, -9.0}, 0.0}), 5.0);
}

TEST(MotionBound, DistanceToAnythingFixedChangesByNoMoreThanReachTimesAngle) {
  std::mt19937_64 generator(20);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  const auto point = [&] { return Eigen::Vector3d(number(generator), number(generator), number(generator)); };
  double largest_use = 0.0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const Capsule body = {point(), point(), 0.1};
    const Capsule fixed = {point(), point(), 0.2};
    const double from = number(generator);
    const double to = from + 0.1 * number(generator);
    const auto distance = [&](double position) {
      return static_cast<double>(exact_distance(placed(body, link_pose(Base{}, position)), fixed));
    };
    const double change = std::abs(distance(to) - distance(from));
    ASSERT_LE(change, reach(body) * std::abs(to - from) + 1e-12);
    largest_use = std::max(largest_use, change / (reach(body) * std::abs(to - from)));
  }
  EXPECT_GT(largest_use, 0.9) << "the bound is not far from what happens";
}

}  // namespace
}  // namespace dualarm

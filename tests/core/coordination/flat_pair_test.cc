#include "core/coordination/flat_pair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/dice.h"
#include "tests/support/random_outline.h"

namespace dualarm {
namespace {

/// Two bodies on their bases, in motion, placed in the world without the help of FlatPair.
struct Scene {
  explicit Scene(Dice& dice) {
    for (int i = 0; i < 2; ++i) {
      bases[i].position = {dice.between(-2.0, 2.0), dice.between(-2.0, 2.0), 0.0};
      bases[i].heading = dice.between(-3.0, 3.0);
      bases[i].rotation = dice.happens(0.5) ? Rotation::kCounterclockwise : Rotation::kClockwise;
      outlines[i] = random_outline(dice);
      courses[i] = {dice.between(-3.0, 3.0), dice.between(-3.0, 3.0), dice.happens(0.2) ? 0.0 : dice.between(0.0, 4.0)};
    }
  }

  Outline placed(int arm, double position) const {
    Outline outline = outlines[arm];
    const Eigen::Rotation2Dd turn(bases[arm].heading + bases[arm].sense() * position);
    for (int i = 0; i < outline.count; ++i) {
      outline.corners[i] = turn * outline.corners[i] + bases[arm].position.head<2>();
    }
    return outline;
  }

  /// At times since the courses' states, with accelerations that are parts of the largest ones.
  double distance(const TimePair& at, double first_part, double second_part) const {
    const auto position = [](const Course& course, double time, double part) {
      return course.position + course.velocity * time + 0.5 * part * course.largest_acceleration * time * time;
    };
    return outline_distance(placed(0, position(courses[0], at.first, first_part)),
                            placed(1, position(courses[1], at.second, second_part)));
  }

  FlatPair pair(double asked) const { return {bases[0], outlines[0], bases[1], outlines[1], asked}; }

  bool stays_apart(double asked, const std::vector<TimePair>& times) const {
    return pair(asked).stays_apart(courses[0], courses[1], times);
  }

  std::array<Base, 2> bases;
  std::array<Outline, 2> outlines;
  std::array<Course, 2> courses;
};

TEST(FlatPair, ProvesNothingThatIsNotTrue) {
  int proven = 0;
  for (int seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Scene scene(dice);
    const double asked = scene.distance({}, 0.0, 0.0) - std::exp(dice.between(-8.0, 0.0));
    const double size = std::exp(dice.between(-5.0, 0.0));
    if (asked < 0.0) continue;
    std::vector<TimePair> times;
    for (int i = 0; i < 4; ++i) times.push_back({dice.between(-size, size), dice.between(-size, size)});
    if (!scene.stays_apart(asked, times)) continue;
    ++proven;
    for (int look = 0; look < 60; ++look) {
      TimePair at;
      double left = 1.0;
      for (const TimePair& corner : times) {
        const double share = &corner == &times.back() ? left : dice.happens(0.3) ? left : left * dice.between(0.0, 1.0);
        at = {at.first + share * corner.first, at.second + share * corner.second};
        left -= share;
      }
      ASSERT_GT(scene.distance(at, dice.one_of(3) - 1.0, dice.one_of(3) - 1.0), asked);
    }
  }
  EXPECT_GT(proven, 800);
}

/// The least distance (m) less than that at the states' for which `times` are proven.
double price(const Scene& scene, const std::vector<TimePair>& times) {
  const double distance = scene.distance({}, 0.0, 0.0);
  double proven = distance;
  double open = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (proven + open);
    (scene.stays_apart(distance - middle, times) ? proven : open) = middle;
  }
  return proven;
}

TEST(FlatPair, ErrsWithTheSquareOfTheTimesWhereTheDistanceDoesNotChange) {
  constexpr double kStep = 1e-6;
  std::vector<double> ratios;
  for (int seed = 0; ratios.size() < 300; ++seed) {
    ASSERT_LT(seed, 3000);
    Dice dice(seed);
    const Scene scene(dice);
    if (scene.distance({}, 0.0, 0.0) < 0.5) continue;
    const double by_first = scene.distance({kStep, 0.0}, 0.0, 0.0) - scene.distance({-kStep, 0.0}, 0.0, 0.0);
    const double by_second = scene.distance({0.0, kStep}, 0.0, 0.0) - scene.distance({0.0, -kStep}, 0.0, 0.0);
    const double rate = std::hypot(by_first, by_second);
    const auto along = [&](double way) {
      const TimePair at = {way * by_second / rate, -way * by_first / rate};
      return std::vector<TimePair>{at, {-at.first, -at.second}};
    };
    ratios.push_back(price(scene, along(0.02)) / price(scene, along(0.005)));
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GT(ratios[ratios.size() / 4], 14.0);  // 16 to second order, 4 to first
}

TEST(FlatPair, ProvesNothingOfBodiesThatCollide) {
  Dice dice(7);
  int colliding = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scene scene(dice);
    const double distance = scene.distance({}, 0.0, 0.0);
    colliding += distance == 0.0;
    EXPECT_FALSE(scene.stays_apart(distance, {{0.0, 0.0}}));
    EXPECT_FALSE(scene.stays_apart(distance + 0.1, {{0.0, 0.0}}));
  }
  EXPECT_GT(colliding, 10);
}

TEST(FlatPair, SlicesWhereItComesAsNearAsIsAsked) {
  int ends = 0;
  for (int seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Scene scene(dice);
    const double asked = dice.between(0.0, 0.5);
    const double theta1 = dice.between(-3.0, 3.0);
    const auto distance = [&](double theta2) {
      return outline_distance(scene.placed(0, theta1), scene.placed(1, theta2));
    };
    const IntervalList slice = scene.pair(asked).slice(theta1, 0.0, {-3.0, 3.0});
    for (const Interval& piece : slice) {
      EXPECT_LE(distance(0.5 * (piece.lower + piece.upper)), asked);
      for (const double end : {piece.lower, piece.upper}) {
        if (std::abs(end) == 3.0 || asked == 0.0) continue;
        ++ends;
        EXPECT_NEAR(distance(end), asked, 1e-9);
      }
    }
    for (int i = 0; i < 30; ++i) {
      const double theta2 = dice.between(-3.0, 3.0);
      const bool inside =
          std::any_of(slice.begin(), slice.end(), [&](const Interval& p) { return p.contains(theta2); });
      EXPECT_EQ(inside, distance(theta2) <= asked) << theta2;
    }
  }
  EXPECT_GT(ends, 300);
}

}  // namespace
}  // namespace dualarm

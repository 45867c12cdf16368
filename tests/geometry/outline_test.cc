#include "geometry/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/dice.h"
#include "tests/support/random_outline.h"

namespace dualarm {
namespace {

/// How far two outlines are apart along a direction: their distance is the most of it, or 0.
double gap_along(const Outline& first, const Outline& second, const Eigen::Vector2d& normal) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < first.count; ++i) {
    for (int k = 0; k < second.count; ++k) {
      least = std::min(least, normal.dot(second.corners[k] - first.corners[i]));
    }
  }
  return least;
}

double widest_gap(const Outline& first, const Outline& second) {
  constexpr int kDirections = 2000;
  double widest = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const Heading heading = heading_of(2.0 * std::numbers::pi * i / kDirections);
    widest = std::max(widest, gap_along(first, second, {heading.cosine, heading.sine}));
  }
  return widest;
}

TEST(Nearest, HasTheDistanceThatTheBestDirectionShows) {
  Dice dice(1);
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Outline first = random_outline(dice);
    const Outline second = random_outline(dice);
    const Nearest found = nearest(figure_of(first), figure_of(second));
    EXPECT_NEAR(found.distance, widest_gap(first, second), 1e-2);  // directions are 3e-3 rad apart
    if (found.distance == 0.0) continue;
    ++apart;
    EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(gap_along(first, second, found.normal), found.distance, 1e-12);
  }
  EXPECT_GT(apart, 100);
}

TEST(Nearest, SaysWhoseFlankIsTouched) {
  const Figure flank = figure_of(outline_of({{-1.0, 0.0}, {1.0, 0.0}}));
  const Figure point = figure_of(outline_of({{0.3, 1.0}, {0.3, 1.0}}));
  const Figure beyond = figure_of(outline_of({{2.0, 1.0}, {2.0, 1.0}}));
  EXPECT_EQ(nearest(flank, point).flank, Nearest::Flank::kOfFirst);
  EXPECT_EQ(nearest(point, flank).flank, Nearest::Flank::kOfSecond);
  EXPECT_EQ(nearest(flank, beyond).flank, Nearest::Flank::kNone);
}

TEST(AreWithin, AgreesWithTheDistance) {
  Dice dice(2);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Figure first = figure_of(random_outline(dice));
    const Figure second = figure_of(random_outline(dice));
    const double distance = nearest(first, second).distance;
    EXPECT_TRUE(are_within(first, second, distance + 1e-12));
    if (distance > 1e-9) {
      EXPECT_FALSE(are_within(first, second, distance - 1e-12));
    }
  }
}

TEST(Moved, TurnsAboutTheOriginAndShifts) {
  const Figure figure =
      moved(figure_of(outline_of({{1.0, 0.0}, {2.0, 0.0}})), heading_of(0.5 * std::numbers::pi), {3, 4});
  EXPECT_NEAR((figure.outline.corners[0] - Eigen::Vector2d(3.0, 5.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((figure.outline.corners[1] - Eigen::Vector2d(3.0, 6.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((figure.along[0] - Eigen::Vector2d(0.0, 1.0)).norm(), 0.0, 1e-15);
}

TEST(Mirrored, StaysCounterclockwise) {
  Dice dice(3);
  for (int i = 0; i < 100; ++i) {
    const Outline outline = mirrored(random_outline(dice));
    for (int k = 0; k < outline.count && outline.count > 2; ++k) {
      const Eigen::Vector2d a = outline.corners[(k + 1) % 4] - outline.corners[k];
      const Eigen::Vector2d b = outline.corners[(k + 2) % 4] - outline.corners[k];
      EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0) << i;
    }
  }
}

}  // namespace
}  // namespace dualarm

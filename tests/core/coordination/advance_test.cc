#include "core/coordination/advance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/clearance.h"
#include "tests/support/dice.h"
#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A body on a joint at the origin that turns about z; the parameter is its angle.
class Turning final : public Wanderer {
 public:
  explicit Turning(const Capsule& capsule) : capsule_(capsule) {}

  Shape shape_at(double angle) const override { return capsule_at(angle); }

  Screw screw_at(double) const override {
    const double reach = std::max(capsule_.start.head<2>().norm(), capsule_.end.head<2>().norm()) + capsule_.radius;
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), reach};
  }

  Capsule capsule_at(double angle) const {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
    return {turn * capsule_.start, turn * capsule_.end, capsule_.radius};
  }

 private:
  Capsule capsule_;
};

Capsule any_capsule(Dice& dice) {
  const auto place = [&] {
    return Eigen::Vector3d(dice.between(-2.0, 2.0), dice.between(-2.0, 2.0), dice.between(-1.0, 1.0));
  };
  return {place(), place(), dice.between(0.0, 0.3)};
}

bool is_inside(const std::vector<Interval>& intervals, double value) {
  return std::any_of(intervals.begin(), intervals.end(), [&](const Interval& one) { return one.contains(value); });
}

/// Where the distance over a turn has a peak, and how it bends there.
struct Peak {
  double angle = 0.0;
  double distance = 0.0;
  double bend = 0.0;  ///< m/rad2
};

template <typename Distance>
std::vector<Peak> peaks_of(const Distance& distance) {
  constexpr int kSamples = 720;
  constexpr double kStep = kTurn / kSamples;
  std::vector<Peak> peaks;
  for (int i = 1; i < kSamples; ++i) {
    double lower = (i - 1) * kStep;
    double upper = (i + 1) * kStep;
    const double middle = distance(i * kStep);
    if (!(middle > distance(lower) && middle > distance(upper))) continue;
    for (int halving = 0; halving < 100; ++halving) {  // golden section
      const double left = lower + 0.381966 * (upper - lower);
      const double right = upper - 0.381966 * (upper - lower);
      (distance(left) < distance(right) ? lower : upper) = distance(left) < distance(right) ? left : right;
    }
    constexpr double kAside = 1e-4;
    const double at = 0.5 * (lower + upper);
    const double peak = distance(at);
    peaks.push_back({at, peak, (2.0 * peak - distance(at - kAside) - distance(at + kAside)) / (kAside * kAside)});
  }
  return peaks;
}

TEST(CollidingParameters, GapsOfTwoMilliradiansStayOpenBetweenLeaningCapsules) {
  constexpr int kSeed = 11;
  SCOPED_TRACE(kSeed);
  Dice dice(kSeed);
  int narrow_gaps = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const Capsule fixed = any_capsule(dice);
    const Turning turning(any_capsule(dice));
    const auto distance = [&](double angle) {
      return static_cast<double>(exact_distance(fixed, turning.capsule_at(angle)));
    };
    for (const Peak& peak : peaks_of(distance)) {
      constexpr double kWidth = 2e-3;
      const double clearance = peak.distance - peak.bend * kWidth * kWidth / 8.0;
      const double error = clearance_error(fixed, turning.shape_at(peak.angle));
      if (!(peak.distance - clearance > error) || !(clearance > 0.0)) continue;
      const auto found = colliding_parameters(fixed, turning, clearance, {0.0, kTurn});
      EXPECT_FALSE(is_inside(found, peak.angle)) << peak.distance << " m, " << peak.bend << " m/rad2";
      for (int i = 0; i <= 100; ++i) {
        const double angle = kTurn * i / 100.0;
        if (distance(angle) < clearance) {
          EXPECT_TRUE(is_inside(found, angle)) << angle;
        }
      }
      ++narrow_gaps;
    }
  }
  EXPECT_GT(narrow_gaps, 100);
}

}  // namespace
}  // namespace dualarm

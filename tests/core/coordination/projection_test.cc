#include "core/coordination/projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/phase_plane/time_optimal.h"
#include "core/systems/single_joint_arm.h"
#include "tests/support/dice.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

/// Positions (rad) and times (s) within an ellipse.
struct Blob {
  double position, time, half_width, half_height;

  Interval times_near(Interval positions) const {
    const double nearest = std::clamp(position, positions.lower, positions.upper);
    const double share = (nearest - position) / half_width;
    const double half = half_height * std::sqrt(std::max(0.0, 1.0 - share * share));
    return share * share > 1.0 ? Interval{1.0, 0.0} : Interval{time - half, time + half};
  }

  /// By looking at many places.
  Interval differences(const Profile& arm) const {
    constexpr int kLooks = 200000;
    const Leg& leg = arm.legs().front();
    Interval found = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int i = 0; i <= kLooks; ++i) {
      const double at = std::clamp(position + half_width * std::cos(std::numbers::pi * i / kLooks),
                                   std::min(leg.start, leg.goal), std::max(leg.start, leg.goal));
      const Interval times = times_near({at, at});
      if (times.empty()) continue;
      const double own = arm.time_at(leg, at);
      found = {std::min(found.lower, own - times.upper), std::max(found.upper, own - times.lower)};
    }
    return found;
  }
};

/// Blobs on an arm's way, and what is known of them from elsewhere.
class Blobs final : public Meetings {
 public:
  Blobs(std::vector<Blob> blobs, std::vector<Interval> truth, bool tells)
      : blobs_(blobs), truth_(truth), tells_(tells) {}

  IntervalList times_at(double position) const override { return times_over({position, position}); }
  IntervalList times_over(Interval positions) const override {
    ++looks_;
    IntervalList found;
    for (const Blob& blob : blobs_) {
      if (const Interval times = blob.times_near(positions); !times.empty()) found.push_back(times);
    }
    return found;
  }
  bool is_free(const Patch& patch) const override {
    EXPECT_TRUE(patch.own.contains(patch.time));
    return tells_ && std::none_of(truth_.begin(), truth_.end(), [&](const Interval& forbidden) {
             return forbidden.lower <= patch.differences.upper && patch.differences.lower <= forbidden.upper;
           });
  }
  int looks() const { return looks_; }

 private:
  std::vector<Blob> blobs_;
  std::vector<Interval> truth_;
  bool tells_;
  mutable int looks_ = 0;
};

class ProjectionTest : public ::testing::Test {
 protected:
  ProjectionTest() : arm_(paper_problem({20, 70}, {80, 20}, 0.1).arms[0]), motion_(of_arm()) {}

  Profile of_arm() const {
    return std::get<FastestMotion>(fastest_motion(arm_, 0.35, 1.4, Swings::kSkip)).profile.asked_often();
  }

  Blob random_blob(Dice& dice) const {
    return {dice.between(0.4, 1.3), dice.between(0.0, 2.0), dice.between(0.05, 0.4), dice.between(0.05, 0.5)};
  }

  IntervalSet projected(const Blobs& blobs) const {
    return project(blobs, motion_, {motion_.duration()}, Budget()).value();
  }

  SingleJointArm arm_;
  Profile motion_;
};

TEST_F(ProjectionTest, EndsWhereManyLooksEndWithAndWithoutProofs) {
  for (int seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Blob blob = random_blob(dice);
    if (!blob.times_near({motion_.start(), motion_.start()}).empty()) continue;
    if (!blob.times_near({motion_.goal(), motion_.goal()}).empty()) continue;
    const Interval truth = blob.differences(motion_);
    for (const bool tells : {false, true}) {
      const IntervalSet found = projected(Blobs({blob}, {truth}, tells));
      ASSERT_EQ(found.intervals().size(), 1U) << tells;
      EXPECT_NEAR(found.intervals()[0].lower, truth.lower, 1e-9) << tells;
      EXPECT_NEAR(found.intervals()[0].upper, truth.upper, 1e-9) << tells;
    }
  }
}

TEST_F(ProjectionTest, LeavesTheGapsBetweenSeveral) {
  int gaps = 0;
  for (int seed = 100; seed < 160; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<Blob> blobs;
    std::vector<Interval> truth;
    while (blobs.size() < 3) {
      const Blob blob = random_blob(dice);
      if (!blob.times_near({motion_.start(), motion_.start()}).empty()) continue;
      if (!blob.times_near({motion_.goal(), motion_.goal()}).empty()) continue;
      blobs.push_back(blob);
      truth.push_back(blob.differences(motion_));
    }
    const IntervalSet expected = unite_across(truth, 3e-4 * motion_.duration());
    for (const bool tells : {false, true}) {
      const IntervalSet found = projected(Blobs(blobs, truth, tells));
      ASSERT_EQ(found.intervals().size(), expected.intervals().size()) << tells;
      for (std::size_t i = 0; i < found.intervals().size(); ++i) {
        EXPECT_NEAR(found.intervals()[i].lower, expected.intervals()[i].lower, 1e-9) << tells;
        EXPECT_NEAR(found.intervals()[i].upper, expected.intervals()[i].upper, 1e-9) << tells;
      }
    }
    gaps += static_cast<int>(expected.intervals().size()) - 1;
  }
  EXPECT_GT(gaps, 20);
}

TEST_F(ProjectionTest, LooksRarelyWhereProofsTell) {
  for (int seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Blob blob = random_blob(dice);
    const Interval truth = blob.differences(motion_);
    const Blobs tells({blob}, {truth}, true);
    projected(tells);
    EXPECT_LT(tells.looks(), 240);
  }
}

}  // namespace
}  // namespace dualarm

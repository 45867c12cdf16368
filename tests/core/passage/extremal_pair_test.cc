#include "core/passage/extremal_pair.h"

#include <gtest/gtest.h>

#include "core/passage/bound.h"
#include "tests/core/passage/scene_travellers.h"
#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kRadius = 0.05;  // m

class ExtremalPairTest : public testing::Test {
 protected:
  Problem problem_ = paper_problem({5, 60}, {50, 10}, kRadius);
  SceneTravellers scene_{problem_};
  ForbiddenPlane plane_{problem_, 0.0};
  PassageBound bound_ = passage_bound(plane_, scene_.travellers, Budget());

  /// The gates that run up from the upper border, beside the slowest one.
  std::vector<Gate> gates_near_by() const {
    std::vector<Gate> gates;
    const Gate& slowest = bound_.ways.front().gate;
    for (double aside = -0.3; aside < 0.01; aside += 0.02) {
      const double position = slowest.pinned_position + aside;
      for (const Interval& stretch : plane_.slice(slowest.pinned_arm, position).intervals()) {
        gates.push_back({slowest.pinned_arm, position, stretch.upper, true});
      }
    }
    return gates;
  }
};

TEST_F(ExtremalPairTest, MeetsInTheGateWhenBothTakeTheWholeDuration) {
  const Way& way = bound_.ways.front();
  const auto pair = extremal_pair(scene_.travellers, way.gate, way.bound, way.bound.duration);
  ASSERT_TRUE(pair);
  const auto arrival = passing_of(pair->early, position_of(way.gate, pair->early_arm), Hurry::kEarlyArrival)->before;
  const auto departure =
      pair->wait() + passing_of(pair->late, position_of(way.gate, 1 - pair->early_arm), Hurry::kLateDeparture)->before;
  EXPECT_NEAR(arrival, departure, 1e-9);
  EXPECT_NEAR(pair->wait(), 0.0, 1e-9);
}

TEST_F(ExtremalPairTest, PassesGatesInTurnThatAskForNoMore) {
  const Way& way = bound_.ways.front();
  const auto pair = extremal_pair(scene_.travellers, way.gate, way.bound, way.bound.duration);
  ASSERT_TRUE(pair);
  const std::vector<Gate> gates = gates_near_by();
  ASSERT_GT(gates.size(), 10u);
  for (const Gate& gate : gates) {
    EXPECT_TRUE(passes_in_turn(*pair, scene_.travellers, gate)) << gate.pinned_position;
    EXPECT_LE(gate_bound(scene_.travellers, gate).duration, way.bound.duration * (1.0 + 1e-9));
  }
}

TEST_F(ExtremalPairTest, DoesNotPassAGateInTurnThatAsksForMore) {
  const Way& way = bound_.ways.front();
  const auto pair = extremal_pair(scene_.travellers, way.gate, way.bound, way.bound.duration);
  ASSERT_TRUE(pair);
  Gate farther = way.gate;
  farther.pinned_position += 0.01;
  farther.corner_position += 0.01;
  EXPECT_GT(gate_bound(scene_.travellers, farther).duration, way.bound.duration);
  EXPECT_FALSE(passes_in_turn(*pair, scene_.travellers, farther));
}

}  // namespace
}  // namespace dualarm

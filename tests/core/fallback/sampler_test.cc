#include "core/fallback/sampler.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/core/fallback/search_space.h"

namespace dualarm {
namespace {

std::vector<JointStates> draw(std::uint64_t seed) {
  const SearchSpace search(retreat_problem(), 1e-4, seed);
  const auto sampler = search.space->allocStateSampler();
  auto state = search.state(0.0, 0.0, 0.0);
  std::vector<JointStates> drawn;
  for (int i = 0; i < 500; ++i) {
    sampler->sampleUniform(state.get());
    EXPECT_TRUE(search.space->satisfiesBounds(state.get()));
    drawn.push_back(StateTimeSpace::states(state.get()));
  }
  return drawn;
}

TEST(Sampler, DrawsTheSameFromTheSameSeedWhateverElseRuns) {
  const auto alone = draw(7);
  std::vector<std::vector<JointStates>> together(4);
  {
    std::vector<std::jthread> threads;
    for (auto& drawn : together) threads.emplace_back([&drawn] { drawn = draw(7); });
  }
  for (const auto& drawn : together) EXPECT_EQ(drawn, alone);
  EXPECT_NE(draw(8), alone);
}

TEST(Sampler, CoversTheRangeAndItsPreferredPositions) {
  const SearchSpace search(retreat_problem());
  Sampler sampler(search.space.get(), 1);
  sampler.prefer(0, {JointState{0.25, 0.5}});
  auto state = search.state(0.0, 0.0, 0.0);
  int preferred = 0;
  int moving = 0;
  std::array<int, 4> quarters = {};
  for (int i = 0; i < 4000; ++i) {
    sampler.sampleUniform(state.get());
    const JointStates states = StateTimeSpace::states(state.get());
    if (states[0] == JointState{0.25, 0.5}) ++preferred;
    if (states[1].velocity != 0.0) ++moving;
    ++quarters[static_cast<int>(states[1].position / (std::numbers::pi / 4.0))];
  }
  EXPECT_NEAR(preferred, 1000, 150);
  EXPECT_NEAR(moving, 1200, 150);
  for (const int count : quarters) EXPECT_NEAR(count, 1000, 150);
}

TEST(Sampler, StaysNearAndInsideTheBounds) {
  const SearchSpace search(retreat_problem());
  Sampler sampler(search.space.get(), 1);
  const auto centre = search.state(1.0, 90.0, 0.01);
  auto state = search.state(0.0, 0.0, 0.0);
  for (int i = 0; i < 200; ++i) {
    sampler.sampleUniformNear(state.get(), centre.get(), 0.1);
    EXPECT_TRUE(search.space->satisfiesBounds(state.get()));
    EXPECT_NEAR(StateTimeSpace::states(state.get())[1].position, 90.0 * kDegree, 0.1);
  }
}

}  // namespace
}  // namespace dualarm

#include "core/fallback/state_time_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/fallback/search_space.h"

namespace dualarm {
namespace {

using Space = ompl::base::StateSpace;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(StateTimeSpace, PassesTheSanityChecksOfOmplThatADirectedSpaceCanPass) {
  // Not: symmetry and the triangle equality (not a metric), the bound (infinite where there is no way), interpolation
  // (OMPL measures it by the distance, which takes rounding in positions for a way that needs time; see below).
  const SearchSpace search(retreat_problem());
  EXPECT_NO_THROW(
      search.space->sanityChecks(std::numeric_limits<double>::epsilon(), std::numeric_limits<float>::epsilon(),
                                 Space::STATESPACE_DISTANCE_DIFFERENT_STATES | Space::STATESPACE_RESPECT_BOUNDS |
                                     Space::STATESPACE_ENFORCE_BOUNDS_NO_OP | Space::STATESPACE_SERIALIZATION));
}

TEST(StateTimeSpace, IsNoMetricAndSaysSo) {
  const SearchSpace search(retreat_problem());
  EXPECT_FALSE(search.space->isMetricSpace());
  EXPECT_FALSE(search.space->hasSymmetricDistance());
  EXPECT_EQ(search.space->getDimension(), 5u);
}

TEST(StateTimeSpace, MeasuresTimeForwardsOnly) {
  const SearchSpace search(retreat_problem());
  const auto here = search.state(10.0, 40.0, 1.0);
  const auto later_elsewhere = search.state(12.0, 45.0, 3.0);
  EXPECT_EQ(search.space->distance(here.get(), here.get()), 0.0);
  EXPECT_EQ(search.space->distance(here.get(), later_elsewhere.get()), 2.0);
  EXPECT_EQ(search.space->distance(later_elsewhere.get(), here.get()), kInfinity);
  EXPECT_EQ(search.space->distance(search.state(10.0, 40.0, 2.0).get(), here.get()), kInfinity);
}

TEST(StateTimeSpace, ReachesAStateNoEarlierThanTheFastestMotionsDo) {
  const SearchSpace search(retreat_problem());
  const auto here = search.state(10.0, 40.0, 0.0);
  const double needed =
      steering_time(search.arms.both(), StateTimeSpace::states(here.get()), at_rest({40.0 * kDegree, 10.0 * kDegree}));
  EXPECT_EQ(search.space->distance(here.get(), search.state(40.0, 10.0, needed).get()), needed);
  EXPECT_EQ(search.space->distance(here.get(), search.state(40.0, 10.0, needed - 1e-9).get()), kInfinity);
}

TEST(StateTimeSpace, KeepsTheTriangleInequalityAlongTime) {
  const SearchSpace search(retreat_problem(), 1e-4, 3);
  const auto sampler = search.space->allocStateSampler();
  ompl::base::ScopedState<StateTimeSpace> a(search.information), b(search.information), c(search.information);
  int finite = 0;
  for (int i = 0; i < 4000; ++i) {
    for (auto* state : {a.get(), b.get(), c.get()}) sampler->sampleUniform(state);
    const double by_way = search.space->distance(a.get(), b.get()) + search.space->distance(b.get(), c.get());
    if (!std::isfinite(by_way)) continue;
    ++finite;
    EXPECT_NEAR(search.space->distance(a.get(), c.get()), by_way, 1e-12);
  }
  EXPECT_GT(finite, 100);
}

TEST(StateTimeSpace, InterpolatesStraight) {
  const SearchSpace search(retreat_problem());
  auto middle = search.state(0.0, 0.0, 0.0);
  search.space->interpolate(search.state(10.0, 40.0, 1.0).get(), search.state(20.0, 60.0, 3.0).get(), 0.5,
                            middle.get());
  EXPECT_NEAR(StateTimeSpace::states(middle.get())[0].position, 15.0 * kDegree, 1e-12);
  EXPECT_NEAR(StateTimeSpace::states(middle.get())[1].position, 50.0 * kDegree, 1e-12);
  EXPECT_NEAR(StateTimeSpace::time(middle.get()), 2.0, 1e-12);
}

}  // namespace
}  // namespace dualarm

#pragma once

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <memory>

#include "core/phase_plane/system.h"

namespace dualarm {

/// What the phase plane assumes of a System (core/phase_plane/system.h), as tests. To hold a new System to them:
/// INSTANTIATE_TYPED_TEST_SUITE_P(Name, SystemLaws, Factory), where Factory::make() returns a vector of systems.
template <class Factory>
class SystemLaws : public testing::Test {
 protected:
  const std::vector<std::shared_ptr<const System>> systems_ = Factory::make();

  static std::vector<double> samples(const System& system) {
    std::vector<double> positions;
    for (int i = 0; i <= 500; ++i) positions.push_back(system.range().lower + system.range().length() * i / 500.0);
    return positions;
  }
};

TYPED_TEST_SUITE_P(SystemLaws);

TYPED_TEST_P(SystemLaws, AdmissibleAccelerationsAreIntervalsWithAnInside) {
  for (const auto& system : this->systems_) {
    for (const double s : this->samples(*system)) {
      EXPECT_LT(system->acceleration(s, 0.0).lower, system->acceleration(s, 0.0).upper);
    }
  }
}

TYPED_TEST_P(SystemLaws, BoundsHoldEverywhereAndAreReached) {
  for (const auto& system : this->systems_) {
    const Interval bounds = system->acceleration_bounds();
    Interval seen = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double s : this->samples(*system)) {
      seen.lower = std::min(seen.lower, system->acceleration(s, 0.0).lower);
      seen.upper = std::max(seen.upper, system->acceleration(s, 0.0).upper);
    }
    const double room = 1e-3 * bounds.length();
    EXPECT_LE(bounds.lower, seen.lower);
    EXPECT_GE(bounds.upper, seen.upper);
    EXPECT_GT(bounds.lower, seen.lower - room);
    EXPECT_LT(bounds.upper, seen.upper + room);
  }
}

TYPED_TEST_P(SystemLaws, VelocityLimitsAllowBothDirections) {
  for (const auto& system : this->systems_) {
    EXPECT_LT(system->velocity().lower, 0.0);
    EXPECT_GT(system->velocity().upper, 0.0);
  }
}

TYPED_TEST_P(SystemLaws, WorkIsTheIntegralOfTheAcceleration) {
  for (const auto& system : this->systems_) {
    for (const Extreme extreme : {Extreme::kLowest, Extreme::kHighest}) {
      for (const double from : this->samples(*system)) {
        for (const double change : {-0.7, -1e-3, 1e-6, 0.4}) {
          if (!system->range().contains(from + change)) continue;
          const double expected = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
              [&](double s) { return system->extreme_acceleration(extreme, s, 0.0); }, from, from + change, 10, 1e-14);
          // The end of the quadrature, from + change, is rounded.
          const double rounding = 1e-15 + 1e-11 * std::abs(change);
          EXPECT_NEAR(system->specific_work(extreme, from, change), expected,
                      system->acceleration_bounds().length() * rounding);
        }
      }
    }
  }
}

TYPED_TEST_P(SystemLaws, SignsChangeOnlyAtTheListedZeros) {
  for (const auto& system : this->systems_) {
    for (const Extreme extreme : {Extreme::kLowest, Extreme::kHighest}) {
      const std::vector<double> zeros = system->zeros(extreme, 0.0, system->range());
      EXPECT_TRUE(std::is_sorted(zeros.begin(), zeros.end()));
      for (const double zero : zeros) {
        EXPECT_NEAR(system->extreme_acceleration(extreme, zero, 0.0), 0.0,
                    1e-9 * system->acceleration_bounds().length());
      }
      const std::vector<double> positions = this->samples(*system);
      for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
        const bool changes = system->extreme_acceleration(extreme, positions[i], 0.0) *
                                 system->extreme_acceleration(extreme, positions[i + 1], 0.0) <
                             0.0;
        const bool listed = std::any_of(zeros.begin(), zeros.end(),
                                        [&](double zero) { return positions[i] <= zero && zero <= positions[i + 1]; });
        EXPECT_TRUE(listed || !changes) << positions[i];
      }
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(SystemLaws, AdmissibleAccelerationsAreIntervalsWithAnInside,
                            BoundsHoldEverywhereAndAreReached, VelocityLimitsAllowBothDirections,
                            WorkIsTheIntegralOfTheAcceleration, SignsChangeOnlyAtTheListedZeros);

}  // namespace dualarm

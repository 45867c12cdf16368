#include "core/phase_plane/sine_slowness.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "tests/support/dice.h"

namespace dualarm {
namespace {

/// An arc that gains speed from its anchor on: the constant is more than gravity takes anywhere. As of an ArcMotion,
/// its speed was gained from rest behind it where that is not farther than the way.
struct GainingArc {
  SineWork work;
  double velocity;
  double away;
  double behind;
  double last;

  explicit GainingArc(Dice& dice) {
    const double gravity = dice.between(0.0, 8.0);
    const double phase = dice.between(-3.0, 3.0);
    away = dice.happens(0.5) ? 1.0 : -1.0;
    work = {away * (gravity + dice.between(0.5, 20.0)), gravity * std::sin(phase), gravity * std::cos(phase)};
    velocity = dice.happens(0.5) ? 0.0 : away * dice.between(0.0, 2.0);
    const double travel = std::pow(10.0, dice.between(-5.0, std::log10(3.0)));
    const double from_rest = 0.5 * velocity * velocity / std::abs(work.rate(0.0));
    behind = from_rest < travel ? from_rest : 0.0;
    last = std::sqrt(behind + travel);
  }

  SineSlowness slowness() const { return {work, velocity, away, behind}; }
  /// What the way loses as a difference of squares of roots, relative.
  double rounding() const { return 4e-16 * last * last / (last * last - behind); }
  double first() const { return std::sqrt(behind); }

  /// By another rule, over the position instead of the root, and with the library's sines: where the anchor is at rest
  /// the rule's nodes crowd at the singularity.
  double time() const {
    const double travel = last * last - behind;
    boost::math::quadrature::tanh_sinh<double> rule;
    return rule.integrate(
        [&](double way) { return 1.0 / std::sqrt(velocity * velocity + 2.0 * work.over(away * way)); }, 0.0, travel,
        1e-14);
  }
};

TEST(SineSlowness, TimesAreThoseOfAnotherRuleOverThePosition) {
  Dice dice(11);
  int told = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "arc " << i << " of seed 11");
    const GainingArc arc(dice);
    const auto time = arc.slowness().time(arc.first(), arc.last);
    if (!time) continue;
    ++told;
    EXPECT_NEAR(*time, arc.time(), (1e-13 + arc.rounding()) * arc.time());
  }
  EXPECT_GT(told, 1800);
}

TEST(SineSlowness, DoesNotTellWhatItsSeriesOrItsNodesCannot) {
  const SineWork work = {5.0, 0.0, 0.0};
  EXPECT_TRUE(SineSlowness(work, 0.0, 1.0, 0.0).time(0.0, std::sqrt(3.19)));
  EXPECT_FALSE(SineSlowness(work, 0.0, 1.0, 0.0).time(0.0, std::sqrt(3.21)));
  // Nearly stalls on the way, or runs out of energy there.
  EXPECT_FALSE(SineSlowness({0.0, 1.0, 0.0}, std::sqrt(4.0 + 1e-9), 1.0, 0.0).time(0.0, 1.7));
  EXPECT_FALSE(SineSlowness({0.0, 1.0, 0.0}, 1.0, 1.0, 0.0).time(0.0, 1.7));
}

}  // namespace
}  // namespace dualarm

#include "core/phase_plane/time_optimal.h"

#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <random>

#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

constexpr double kPi = std::numbers::pi;

/// Motions that turn back are the matter of swing_test.cc and turns_test.cc.
FastestMotion must_move(const SingleJointArm& system, double start, double goal) {
  auto result = fastest_motion(system, start, goal, Swings::kSkip);
  EXPECT_TRUE(std::holds_alternative<FastestMotion>(result)) << start << " -> " << goal;
  return std::get<FastestMotion>(std::move(result));
}

Blocked must_block(const SingleJointArm& system, double start, double goal) {
  auto result = fastest_motion(system, start, goal, Swings::kSkip);
  EXPECT_TRUE(std::holds_alternative<Blocked>(result)) << start << " -> " << goal;
  return std::get<Blocked>(result);
}

std::vector<ArcKind> kinds(const Profile& profile) {
  std::vector<ArcKind> result;
  for (const Arc& arc : profile.arcs()) result.push_back(arc.kind);
  return result;
}

using Kinds = std::vector<ArcKind>;

TEST(FastestMotion, OfADoubleIntegratorIsTwiceTheRootOfDistanceOverAcceleration) {
  const SingleJointArm system(pendulum(2.0, 0.0, 6.0));
  for (const double distance : {1e-6, 0.01, 1.0, 3.0}) {
    const double expected = 2.0 * std::sqrt(distance / 3.0);
    EXPECT_NEAR(must_move(system, 0.0, distance).profile.duration(), expected, 1e-12 * expected);
    EXPECT_NEAR(must_move(system, distance, 0.0).profile.duration(), expected, 1e-12 * expected);
  }
}

TEST(FastestMotion, OfADoubleIntegratorWithAVelocityLimitIsATrapezoid) {
  Arm arm = pendulum(1.0, 0.0, 4.0);
  arm.velocity = {-1.0, 2.0};
  const SingleJointArm system(arm);
  const FastestMotion up = must_move(system, 0.0, 3.0);
  EXPECT_NEAR(up.profile.duration(), 3.0 / 2.0 + 2.0 / 4.0, 1e-12);
  EXPECT_EQ(kinds(up.profile), (Kinds{ArcKind::kAccelerate, ArcKind::kCruise, ArcKind::kBrake}));
  EXPECT_NEAR(must_move(system, 3.0, 0.0).profile.duration(), 3.0 / 1.0 + 1.0 / 4.0, 1e-12);
}

TEST(FastestMotion, OfThePapersArmsTakesTheWorkedTimes) {
  // theory.md, section 4: l = 6, m = 1, J = 3, g = 9.81, |tau| <= 60, |omega| <= 2; degrees, seconds.
  Arm arm = pendulum(39.0, 29.43, 60.0);
  arm.velocity = {-2.0, 2.0};
  arm.joint_range = {0.0, kPi};
  const SingleJointArm system(arm);
  const double rows[][3] = {{30, 60, 1.188197}, {20, 90, 1.767860}, {20, 60, 1.333816}, {70, 20, 1.489711},
                            {10, 60, 1.451674}, {80, 15, 1.675828}, {5, 50, 1.365145},  {10, 40, 1.134967}};
  for (const auto& [start, goal, seconds] : rows) {
    const FastestMotion motion = must_move(system, start * kPi / 180.0, goal * kPi / 180.0);
    EXPECT_NEAR(motion.profile.duration(), seconds, 6e-7) << start << " -> " << goal;
    EXPECT_EQ(motion.minimum_over, MinimumOver::kAllMotions);
    EXPECT_EQ(motion.lower_bound, motion.profile.duration());
  }
}

TEST(FastestMotion, SwitchesWhereTheClosedFormSays) {
  // theory.md, section 1.1: the switch angle is linear in the torques.
  Arm arm = pendulum(39.0, 29.43, 60.0);
  arm.torque = Interval{-45.0, 70.0};
  const double start = 0.3;
  const double goal = 1.4;
  const double expected = (70.0 * start + 45.0 * goal + 29.43 * (std::cos(start) - std::cos(goal))) / (70.0 + 45.0);
  const FastestMotion motion = must_move(SingleJointArm(arm), start, goal);
  EXPECT_NEAR(motion.profile.arcs()[0].end.position, expected, 1e-14);
}

TEST(FastestMotion, OfAWeakArmTakesTheMonotoneTimesOfTheReference) {
  // theory.md, section 1.3: I = 1, G = 1, rest to upright rest, monotone.
  const double rows[][3] = {{0.0, 0.76, 6.191},
                            {0.0, 0.80, 5.359},
                            {0.5 * kPi, 1.01, 10.701},
                            {0.5 * kPi, 1.05, 6.418},
                            {0.5 * kPi, 1.10, 5.062}};
  for (const auto& [start, torque, seconds] : rows) {
    const FastestMotion motion = must_move(SingleJointArm(pendulum(1.0, 1.0, torque)), start, kPi);
    EXPECT_NEAR(motion.profile.duration(), seconds, 5.1e-4) << start << " " << torque;
  }
}

TEST(FastestMotion, ClaimsOnlyMonotoneMotionsForAWeakArm) {
  const FastestMotion motion = must_move(SingleJointArm(pendulum(1.0, 1.0, 0.76)), 0.0, kPi);
  EXPECT_EQ(motion.minimum_over, MinimumOver::kMonotoneMotions);
  EXPECT_LT(motion.lower_bound, 5.790);  // the back-swing of the reference is faster than any monotone motion
  EXPECT_GT(motion.lower_bound, 0.0);
}

TEST(FastestMotion, FindsTheLeastTorqueThatLiftsAHangingArm) {
  // 0.7246 = max over x of (1 - cos x) / x; theory.md, section 1.3.
  EXPECT_EQ(must_block(SingleJointArm(pendulum(1.0, 1.0, 0.7246)), 0.0, kPi).reason, BlockReason::kStalls);
  must_move(SingleJointArm(pendulum(1.0, 1.0, 0.7247)), 0.0, kPi);
}

TEST(FastestMotion, StallsWhereGravityHasUsedUpTheEnergy) {
  const Blocked blocked = must_block(SingleJointArm(pendulum(1.0, 1.0, 0.6)), 0.0, kPi);
  EXPECT_EQ(blocked.reason, BlockReason::kStalls);
  EXPECT_NEAR(0.6 * blocked.position, 1.0 - std::cos(blocked.position), 1e-12);  // work done = energy needed
}

TEST(FastestMotion, CannotComeDownOntoAPlaceWhereItCannotBrake) {
  const Blocked blocked = must_block(SingleJointArm(pendulum(1.0, 1.0, 0.6)), kPi, 0.0);
  EXPECT_EQ(blocked.reason, BlockReason::kCannotBrake);
}

TEST(FastestMotion, ProvesThatNoSwingHelpsOnlyWhereNoneCan) {
  // theory.md, section 1.3: at T/G = 0.60 a back-swing of 6.696 s lifts the arm, if its range allows it.
  Arm arm = pendulum(1.0, 1.0, 0.6);
  const Blocked free = must_block(SingleJointArm(arm), 0.0, kPi);
  EXPECT_FALSE(free.is_proven);
  EXPECT_LT(free.lower_bound, 6.696);
  EXPECT_GT(free.lower_bound, 0.0);
  const Blocked down = must_block(SingleJointArm(arm), kPi, 0.0);
  EXPECT_EQ(down.reason, BlockReason::kCannotBrake);
  EXPECT_FALSE(down.is_proven);
  arm.joint_range = {0.0, kPi};
  EXPECT_TRUE(must_block(SingleJointArm(arm), 0.0, kPi).is_proven);
  EXPECT_TRUE(must_block(SingleJointArm(arm), kPi, 0.0).is_proven);
}

TEST(FastestMotion, ProvesWhereSwingingBackGainsTooLittle) {
  // Energy gained on the way from q: 0.6 (x - q) - (cos q - cos x). From q = -0.3 it is negative at x = 2.2; from the
  // holdable q = -0.64 too, but a swing to q = -1.5 would do.
  Arm arm = pendulum(1.0, 1.0, 0.6);
  for (const double q : {-0.3, -1.5}) {
    arm.joint_range = {q, kPi};
    const auto energy = [&](double x) { return 0.6 * (x - q) - (std::cos(q) - std::cos(x)); };
    double least = 1.0;
    for (double x = q + 0.5; x < kPi; x += 0.01) least = std::min(least, energy(x));
    EXPECT_EQ(must_block(SingleJointArm(arm), 0.0, kPi).is_proven, least < 0.0) << q;
  }
}

TEST(FastestMotion, RefusesEndsThatCannotBeHeld) {
  const SingleJointArm system(pendulum(1.0, 1.0, 0.5));
  EXPECT_EQ(must_block(system, 1.5, 0.1).reason, BlockReason::kStartNotHoldable);
  EXPECT_EQ(must_block(system, 0.1, 1.5).reason, BlockReason::kGoalNotHoldable);
}

TEST(FastestMotion, RefusesEndsOutsideTheRange) {
  const SingleJointArm system(pendulum(1.0, 1.0, 5.0));
  EXPECT_EQ(must_block(system, 11.0, 0.0).reason, BlockReason::kStartOutsideRange);
  EXPECT_EQ(must_block(system, 0.0, -11.0).reason, BlockReason::kGoalOutsideRange);
}

TEST(FastestMotion, SlidesBelowTheVelocityLimitWhereTheDriveCannotHoldIt) {
  // Upwards through the horizontal, where gravity is stronger than the drive: the limit cannot be held there.
  Arm arm = pendulum(1.0, 1.0, 0.9);
  arm.velocity = {-0.6, 0.6};
  const FastestMotion motion = must_move(SingleJointArm(arm), 0.0, kPi);
  EXPECT_EQ(kinds(motion.profile),
            (Kinds{ArcKind::kAccelerate, ArcKind::kCruise, ArcKind::kAccelerate, ArcKind::kCruise, ArcKind::kBrake}));
  EXPECT_NEAR(motion.profile.arcs()[1].end.position, std::asin(0.9), 1e-12);
}

TEST(FastestMotion, LeavesTheVelocityLimitBeforeTheDrivesBrakesAreTooWeak) {
  Arm arm = pendulum(1.0, 1.0, 0.9);
  arm.velocity = {-0.6, 0.6};
  const FastestMotion motion = must_move(SingleJointArm(arm), kPi, 0.0);
  EXPECT_EQ(kinds(motion.profile),
            (Kinds{ArcKind::kAccelerate, ArcKind::kCruise, ArcKind::kBrake, ArcKind::kCruise, ArcKind::kBrake}));
  for (const Arc& arc : motion.profile.arcs()) EXPECT_LE(std::abs(arc.end.velocity), 0.6 + 1e-12);
}

TEST(FastestMotion, StandsStillWhereStartIsGoal) {
  const FastestMotion motion = must_move(SingleJointArm(pendulum(1.0, 1.0, 2.0)), 0.4, 0.4);
  EXPECT_EQ(motion.profile.duration(), 0.0);
  EXPECT_TRUE(motion.profile.stands_still());
}

TEST(FastestMotion, EndsWhereTheDriveIsWeakerThanGravityByARounding) {
  // Between two zeros of the acceleration that nearly coincide, neither leaving the velocity limit nor staying on it
  // makes a difference that shows.
  for (const double shortfall : {1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6}) {
    Arm arm = pendulum(39.0, 29.43, 29.43 * (1.0 - shortfall));
    arm.velocity = {-0.3, 0.3};
    const SingleJointArm system(arm);
    for (const auto& [start, goal] : {std::pair{0.35, 2.8}, {2.8, 0.35}, {-0.35, -2.8}, {-2.8, -0.35}}) {
      const Profile profile = must_move(system, start, goal).profile;
      EXPECT_NEAR(profile.duration(), 9.0, 3.0) << shortfall << " " << start;
    }
  }
  // 0.02 kg on 6.4 m: the decimal of m g l / 2 is a last bit below what the drive has to hold.
  Arm arm = pendulum(3.8192, 0.5 * 0.02 * 9.81 * 6.4, 0.62784);
  arm.velocity = {-0.3, 0.3};
  must_move(SingleJointArm(arm), 0.35, 2.8);
}

/// One bang-bang problem in time, in long double: accelerate for t1, (cruise,) brake for t2. Shares nothing with the
/// phase plane: it integrates both arcs in time and solves for the times at which they meet.
class TimeDomainSolution {
 public:
  TimeDomainSolution(const Arm& arm, double start, double goal) : arm_(arm), start_(start), goal_(goal) {}

  long double duration() const {
    const long double limit = rising() ? arm_.velocity.upper : arm_.velocity.lower;
    // Where both accelerations are what they are half way, each arc would take this long.
    const long double middle = 0.5L * (start_ + goal_);
    const long double drive = std::abs(acceleration(middle, true));
    const long double brake = std::abs(acceleration(middle, false));
    const long double peak = std::sqrt(2.0L * std::abs(goal_ - start_) / (1.0L / drive + 1.0L / brake));
    long double t1 = peak / drive;
    long double t2 = peak / brake;
    if (std::isfinite(static_cast<double>(limit))) {
      const long double driven = time_to_reach(limit, true);
      const long double braked = time_to_reach(limit, false);
      const long double gap = state(braked, false)[0] - state(driven, true)[0];
      if ((rising() ? gap : -gap) >= 0.0L) return driven + gap / limit + braked;
    }
    return meeting(t1, t2);
  }

 private:
  using State = std::array<long double, 2>;
  bool rising() const { return goal_ > start_; }

  long double acceleration(long double theta, bool driving) const {
    const long double torque =
        driving == rising() ? std::get<Interval>(arm_.torque).upper : std::get<Interval>(arm_.torque).lower;
    return (torque - static_cast<long double>(arm_.gravity.amplitude) *
                         std::sin(theta - static_cast<long double>(arm_.gravity.phase))) /
           static_cast<long double>(arm_.inertia);
  }

  /// After `time` of driving from the start, or `time` before the goal while braking.
  State state(long double time, bool driving) const {
    boost::numeric::odeint::runge_kutta_fehlberg78<State, long double> stepper;
    State now = {driving ? start_ : goal_, 0.0L};
    constexpr int kSteps = 48;
    const long double step = (driving ? time : -time) / kSteps;
    const auto rate = [&](const State& at, State& change, long double) {
      change = {at[1], acceleration(at[0], driving)};
    };
    for (int i = 0; i < kSteps; ++i) stepper.do_step(rate, now, 0.0L, step);
    return now;
  }

  long double time_to_reach(long double velocity, bool driving) const {
    long double time = 0.01L;
    for (int i = 0; i < 60; ++i) {
      const State now = state(time, driving);
      const long double slope = driving ? acceleration(now[0], true) : -acceleration(now[0], false);
      const long double change = (velocity - now[1]) / slope;
      time = std::max(time + change, 0.3L * time);
      if (std::abs(change) < 1e-17L * time) break;
    }
    return time;
  }

  /// Newton for equal position and velocity of the two arcs.
  long double meeting(long double t1, long double t2) const {
    for (int i = 0; i < 200; ++i) {
      const State a = state(t1, true);
      const State b = state(t2, false);
      const long double a1 = acceleration(a[0], true);
      const long double a2 = acceleration(b[0], false);
      // d(a)/dt1 = (omega_a, a1), d(b)/dt2 = -(omega_b, a2); solve a + da = b + db.
      const long double det = a[1] * a2 - b[1] * a1;
      const long double position = b[0] - a[0];
      const long double velocity = b[1] - a[1];
      long double d1 = (position * a2 - b[1] * velocity) / det;
      long double d2 = (a[1] * velocity - a1 * position) / det;
      if (!std::isfinite(static_cast<double>(d1))) d1 = d2 = 0.05L;
      const long double most = 0.5L * std::min(t1, t2);
      const long double scale = std::min(1.0L, most / std::max(std::abs(d1), std::abs(d2)));
      t1 += scale * d1;
      t2 += scale * d2;
      if (std::abs(d1) + std::abs(d2) < 1e-17L * (t1 + t2)) break;
    }
    const State a = state(t1, true);
    const State b = state(t2, false);
    EXPECT_LT(std::abs(static_cast<double>(a[0] - b[0])) + std::abs(static_cast<double>(a[1] - b[1])), 1e-14);
    return t1 + t2;
  }

  const Arm& arm_;
  long double start_;
  long double goal_;
};

TEST(FastestMotion, TakesTheTimeOfAHighPrecisionIntegration) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int cruises = 0;
  for (int round = 0; round < 500; ++round) {
    Arm arm = pendulum(draw(0.1, 50.0), draw(0.0, 40.0), 1.0);
    arm.gravity.phase = draw(-kPi, kPi);
    arm.torque = Interval{-arm.gravity.amplitude - draw(0.5, 60.0), arm.gravity.amplitude + draw(0.5, 60.0)};
    const double limit = round % 2 == 0 ? std::numeric_limits<double>::infinity() : draw(0.3, 4.0);
    arm.velocity = {-limit, limit};
    const double start = draw(-3.0, 3.0);
    const double goal = start + (round % 4 < 2 ? 1.0 : -1.0) * draw(0.01, 2.5);
    const Profile profile = must_move(SingleJointArm(arm), start, goal).profile;
    cruises += profile.arcs().size() == 3 ? 1 : 0;
    const double expected = static_cast<double>(TimeDomainSolution(arm, start, goal).duration());
    ASSERT_NEAR(profile.duration(), expected, 1e-9 * expected) << "round " << round;
  }
  EXPECT_GT(cruises, 50);
}

TEST(FastestMotion, IsNeverSlowerWithMoreTorque) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  for (int round = 0; round < 200; ++round) {
    const double start = angle(random);
    const double goal = angle(random);
    double previous = std::numeric_limits<double>::infinity();
    for (const double torque : {1.1, 1.5, 2.0, 8.0}) {
      const double duration = must_move(SingleJointArm(pendulum(1.0, 1.0, torque)), start, goal).profile.duration();
      EXPECT_LE(duration, previous);
      previous = duration;
    }
  }
}

TEST(FastestMotion, TakesAsLongBackAsForthAndMirrored) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  const SingleJointArm system(pendulum(1.0, 1.0, 1.3));
  for (int round = 0; round < 200; ++round) {
    const double start = angle(random);
    const double goal = angle(random);
    const double forth = must_move(system, start, goal).profile.duration();
    EXPECT_NEAR(must_move(system, goal, start).profile.duration(), forth, 1e-11 * forth);
    EXPECT_NEAR(must_move(system, -start, -goal).profile.duration(), forth, 1e-11 * forth);
  }
}

}  // namespace
}  // namespace dualarm

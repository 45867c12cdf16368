#include "tests/core/fallback/schedule_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace dualarm {
namespace {

/// rad and s: what a few additions may lose.
constexpr double kRounding = 1e-14;

/// rad/s: what a velocity found by integration may lose where two motions join.
constexpr double kJoint = 1e-10;

using Point = std::complex<double>;

double cross(Point a, Point b) { return std::imag(std::conj(a) * b); }

double point_to_segment(Point p, Point a, Point b) {
  const double along = std::norm(b - a) > 0.0 ? std::real(std::conj(b - a) * (p - a)) / std::norm(b - a) : 0.0;
  return std::abs(p - (a + std::clamp(along, 0.0, 1.0) * (b - a)));
}

double segment_to_segment(Point a, Point b, Point c, Point d) {
  const bool cd_apart = cross(b - a, c - a) * cross(b - a, d - a) > 0.0;
  const bool ab_apart = cross(d - c, a - c) * cross(d - c, b - c) > 0.0;
  if (!cd_apart && !ab_apart && cross(b - a, d - c) != 0.0) return 0.0;
  return std::min(
      {point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b), point_to_segment(d, a, b)});
}

Point base_of(const Arm& arm) { return {arm.base.position.x(), arm.base.position.y()}; }

Point tip_of(const Arm& arm, double position) {
  return base_of(arm) + std::polar(arm.length, arm.base.heading + arm.base.sense() * position);
}

struct Instant {
  double time;
  JointState state;
};

/// An arm's states in order of time, so dense that a cubic between two is exact to 1e-9 rad.
std::vector<Instant> states_of(const std::vector<TimedProfile>& motions) {
  constexpr int kPieces = 100;
  std::vector<Instant> instants = {{0.0, motions.front().profile.start_state()}};
  for (const auto& [start_time, profile] : motions) {
    for (const Arc& arc : profile.arcs()) {
      const std::vector<JointState> states = profile.states_along(arc, kPieces);
      for (int i = 0; i <= kPieces; ++i) {
        const double time = start_time + arc.start_time + (arc.end_time - arc.start_time) * i / kPieces;
        instants.push_back({time, states[i]});
      }
    }
  }
  return instants;
}

double position_at(const std::vector<Instant>& instants, double time) {
  const auto after = std::upper_bound(instants.begin(), instants.end(), time,
                                      [](double value, const Instant& instant) { return value < instant.time; });
  if (after == instants.end()) return instants.back().state.position;
  const auto& [from_time, from] = *(after - 1);
  const double span = after->time - from_time;
  const double u = (time - from_time) / span;
  const double rise = after->state.position - from.position;
  const double v0 = from.velocity * span;
  const double v1 = after->state.velocity * span;
  return from.position + u * (v0 + u * (3.0 * rise - 2.0 * v0 - v1 + u * (v0 + v1 - 2.0 * rise)));
}

Eigen::Vector3d middle_of(const Object& ball, double time) {
  if (const auto* moving = std::get_if<MovingPlacement>(&ball.placement)) {
    return moving->track.pose_at(time).translation();
  }
  return std::get<FixedPlacement>(ball.placement).pose.translation();
}

double gap_at(const Problem& problem, const JointPair& positions, double time) {
  std::array<Point, kArmCount> bases;
  std::array<Point, kArmCount> tips;
  for (int arm = 0; arm < kArmCount; ++arm) {
    bases[arm] = base_of(problem.arms[arm]);
    tips[arm] = tip_of(problem.arms[arm], positions[arm]);
  }
  double gap =
      segment_to_segment(bases[0], tips[0], bases[1], tips[1]) - problem.arms[0].radius - problem.arms[1].radius;
  for (const Object& object : problem.objects) {
    const Eigen::Vector3d centre = middle_of(object, time);
    for (int arm = 0; arm < kArmCount; ++arm) {
      const double apart = point_to_segment({centre.x(), centre.y()}, bases[arm], tips[arm]);
      gap = std::min(gap, apart - problem.arms[arm].radius - std::get<Capsule>(object.shape).radius);
    }
  }
  return gap;
}

}  // namespace

double smallest_gap(const Problem& problem, const Schedule& schedule, double duration, int count) {
  const std::array<std::vector<Instant>, kArmCount> instants = {states_of(schedule[0]), states_of(schedule[1])};
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= count; ++i) {
    const double time = duration * i / count;
    smallest =
        std::min(smallest, gap_at(problem, {position_at(instants[0], time), position_at(instants[1], time)}, time));
  }
  return smallest;
}

void expect_consistent(const Problem& problem, const Schedule& schedule, double duration) {
  double last_arrival = 0.0;
  for (int arm = 0; arm < kArmCount; ++arm) {
    ASSERT_FALSE(schedule[arm].empty());
    EXPECT_NEAR(schedule[arm].front().profile.start(), problem.tasks[arm].start.position, kRounding);
    EXPECT_NEAR(schedule[arm].front().profile.start_state().velocity, problem.tasks[arm].start.velocity, kRounding);
    EXPECT_NEAR(schedule[arm].back().profile.goal(), problem.tasks[arm].goal.position, kRounding);
    EXPECT_NEAR(schedule[arm].back().profile.goal_state().velocity, problem.tasks[arm].goal.velocity, kRounding);
    double free_from = 0.0;
    JointState at = problem.tasks[arm].start;
    for (const auto& [start_time, profile] : schedule[arm]) {
      EXPECT_GE(start_time, free_from - kRounding);
      EXPECT_NEAR(profile.start(), at.position, kRounding);
      EXPECT_NEAR(profile.start_state().velocity, at.velocity, kJoint);
      if (at.velocity != 0.0) {
        EXPECT_NEAR(start_time, free_from, kRounding);
      }
      EXPECT_TRUE(problem.arms[arm].joint_range.contains(profile.goal()));
      at = profile.goal_state();
      free_from = start_time + profile.duration();
    }
    last_arrival = std::max(last_arrival, free_from);
  }
  EXPECT_NEAR(duration, last_arrival, 1e-9);
}

}  // namespace dualarm

#include "tests/reference/transcription_scene.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "tests/support/exact_distance.h"

namespace dualarm {
namespace {

constexpr long double kCrossing = 1e-12L;  // m, what rounding leaves of the distance of axes that cross
constexpr int kBits = 26;                  // of an instant: all that a double's minimum can have

Capsule axis_of(const Arm& arm, double position) {
  const double direction = arm.base.heading + arm.base.sense() * position;
  const Eigen::Vector3d tip =
      arm.base.position + arm.length * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
  return {arm.base.position, tip, 0.0};
}

long double point_distance(const Eigen::Vector3d& point, const Capsule& axis) {
  return exact_distance(Capsule{point, point, 0.0}, axis);
}

/// The smallest separation (m) in each part of a time (s).
std::vector<double> smallest_separations(const Problem& problem, const std::array<ScriptedMotion, kArmCount>& motions,
                                         double duration, const Rehearsing& how) {
  const auto separation_at = [&](double time) {
    return separation(problem, {motions[0].position_at(time), motions[1].position_at(time)});
  };
  const int per_part = how.nodes + 1;
  const double spacing = duration / (how.parts * per_part);
  std::vector<double> at_nodes;
  for (int node = 0; node <= how.parts * per_part; ++node) at_nodes.push_back(separation_at(spacing * node));
  std::vector<double> smallest;
  for (int part = 0; part < how.parts; ++part) {
    const auto begin = at_nodes.begin() + part * per_part;
    const auto least = std::min_element(begin, begin + per_part + 1);
    smallest.push_back(*least);
    if (*least >= how.near) continue;
    const double time = spacing * static_cast<double>(least - at_nodes.begin());
    const double from = std::max(time - spacing, spacing * part * per_part);
    const double to = std::min(time + spacing, spacing * (part + 1) * per_part);
    const double between = boost::math::tools::brent_find_minima(separation_at, from, to, kBits).second;
    smallest.back() = std::min(*least, between);
  }
  return smallest;
}

}  // namespace

double separation(const Problem& problem, std::array<double, kArmCount> positions) {
  const Capsule first = axis_of(problem.arms[0], positions[0]);
  const Capsule second = axis_of(problem.arms[1], positions[1]);
  long double distance = exact_distance(first, second);
  if (distance < kCrossing) {
    distance = -std::min({point_distance(first.start, second), point_distance(first.end, second),
                          point_distance(second.start, first), point_distance(second.end, first)});
  }
  return static_cast<double>(distance) - problem.arms[0].radius - problem.arms[1].radius;
}

Rehearsal rehearse(const Problem& problem, const Scripts& scripts, double duration, const Rehearsing& how) {
  Rehearsal result;
  const std::array<ScriptedMotion, kArmCount> motions = {
      ScriptedMotion(problem.arms[0], problem.tasks[0].start, scripts[0], how.steps),
      ScriptedMotion(problem.arms[1], problem.tasks[1].start, scripts[1], how.steps)};
  for (int i = 0; i < kArmCount; ++i) {
    const JointState end = motions[i].end();
    result.position_miss[i] = end.position - problem.tasks[i].goal.position;
    result.velocity_miss[i] = end.velocity - problem.tasks[i].goal.velocity;
    result.positions[i] = motions[i].swept();
    result.torque_shortfall = std::max(result.torque_shortfall, motions[i].torque_shortfall());
  }
  result.separations = smallest_separations(problem, motions, duration, how);
  return result;
}

double clearance_miss(const Problem& problem, const Rehearsal& rehearsal) {
  return problem.options.clearance - *std::min_element(rehearsal.separations.begin(), rehearsal.separations.end());
}

}  // namespace dualarm

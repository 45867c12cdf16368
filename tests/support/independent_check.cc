#include "tests/support/independent_check.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <sstream>
#include <utility>
#include <variant>

#include "tests/support/independent_clearance.h"

namespace dualarm {
namespace {

constexpr double kStateTolerance = 1e-6;      // rad and rad/s
constexpr double kDistanceTolerance = 1e-6;   // m
constexpr double kTouching = 1e-12;           // m, what rounding leaves of bare segments that cross
constexpr double kShareTolerance = 1e-5;      // of a limit's span
constexpr double kLongestIntegration = 0.25;  // s; then again from a knot, since standing arms are unstable
constexpr double kOnABend = 1e-9;             // rad and rad/s, this close a state is on a bend of the limits
constexpr int kInstants = 10000;

using State = std::array<double, 2>;

template <typename... Parts>
std::string words(const Parts&... parts) {
  std::ostringstream text;
  text.precision(12);
  (text << ... << parts);
  return text.str();
}

/// Where a value lies on a grid, clamped to it: the entry below, and the share of the way to the next one.
std::pair<std::size_t, long double> place_on(const std::vector<double>& grid, long double value) {
  if (value <= grid.front()) return {0, 0.0L};
  for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
    const long double from = grid[i];
    if (value < grid[i + 1]) return {i, (value - from) / (grid[i + 1] - from)};
  }
  return {grid.size() - 1, 0.0L};
}

struct Limits {
  long double lower = 0.0L;
  long double upper = 0.0L;
};

/// What the drive can give in a state, by the definitions of the limits and not by the code of core/model.
Limits limits_at(const TorqueLimit& limit, long double position, long double velocity) {
  if (const auto* constant = std::get_if<Interval>(&limit)) return {constant->lower, constant->upper};
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) {
    const long double stall = line->stall_torque;
    const long double left = std::max(0.0L, stall - stall / line->no_load_speed * std::abs(velocity));
    return {velocity < 0.0L ? -left : -stall, velocity > 0.0L ? left : stall};
  }
  const TorqueTable& table = std::get<TorqueTable>(limit);
  const auto [row, to_next_row] = place_on(table.positions, position);
  const auto [column, to_next_column] = place_on(table.velocities, velocity);
  Limits sum;
  for (const std::size_t down : {0, 1}) {
    for (const std::size_t across : {0, 1}) {
      const long double weight =
          (down == 1 ? to_next_row : 1.0L - to_next_row) * (across == 1 ? to_next_column : 1.0L - to_next_column);
      if (weight == 0.0L) continue;  // as on the last row and column, which have no next one
      const Interval& corner = table.limits[(row + down) * table.velocities.size() + column + across];
      sum.lower += weight * corner.lower;
      sum.upper += weight * corner.upper;
    }
  }
  return sum;
}

/// Whether the limits have a bend between two values of a coordinate.
bool bends_between(const std::vector<double>& bends, double before, double after) {
  const auto [low, high] = std::minmax({before, after});
  return std::any_of(bends.begin(), bends.end(),
                     [low = low + kOnABend, high = high - kOnABend](double bend) { return low < bend && bend < high; });
}

/// Whether full torque may have a bend at knot k: the limits have one between its neighbours.
bool may_bend(const TorqueLimit& limit, const std::vector<Knot>& knots, std::size_t k) {
  const Knot& before = knots[k - 1];
  const Knot& after = knots[k + 1];
  if (const auto* line = std::get_if<TorqueSpeedLine>(&limit)) {
    return bends_between({-line->no_load_speed, 0.0, line->no_load_speed}, before.velocity, after.velocity);
  }
  const auto* table = std::get_if<TorqueTable>(&limit);
  return table != nullptr && (bends_between(table->positions, before.position, after.position) ||
                              bends_between(table->velocities, before.velocity, after.velocity));
}

/// Torque at a time by Lagrange's polynomial through the knots from `begin` to `end`.
double torque_at(const std::vector<Knot>& knots, std::size_t begin, std::size_t end, double time) {
  double torque = 0.0;
  for (std::size_t i = begin; i <= end; ++i) {
    double weight = 1.0;
    for (std::size_t j = begin; j <= end; ++j) {
      if (j != i) weight *= (time - knots[j].time) / (knots[i].time - knots[j].time);
    }
    torque += weight * knots[i].torque;
  }
  return torque;
}

void check_torque(const Arm& arm, const State& state, double torque, double time,
                  std::vector<std::string>& complaints) {
  const Limits limits = limits_at(arm.torque, state[0], state[1]);
  const long double slack = kShareTolerance * (limits.upper - limits.lower);
  if (torque >= limits.lower - slack && torque <= limits.upper + slack) return;
  complaints.push_back(words(arm.name, ": torque ", torque, " N m at ", time, " s, beyond ", limits.lower, " and ",
                             limits.upper, " N m"));
}

/// Integrates the knots from `first` to `last`, between which no time repeats.
void check_dynamics(const Arm& arm, const std::vector<Knot>& knots, std::size_t first, std::size_t last,
                    std::vector<std::string>& complaints) {
  namespace odeint = boost::numeric::odeint;
  const double growth = std::sqrt(std::abs(arm.gravity.amplitude) / arm.inertia);
  State state = {knots[first].position, knots[first].velocity};
  double begun = knots[first].time;
  for (std::size_t k = first; k < last; ++k) {
    const std::size_t from = k > first && !may_bend(arm.torque, knots, k) ? k - 1 : k;
    const std::size_t to = k + 2 <= last && !may_bend(arm.torque, knots, k + 1) ? k + 2 : k + 1;
    const auto motion = [&](const State& x, State& rate, double time) {
      const double held = arm.gravity.amplitude * std::sin(x[0] - arm.gravity.phase) + arm.viscous_friction * x[1];
      rate = {x[1], (torque_at(knots, from, to, time) - held) / arm.inertia};
    };
    const double h = knots[k + 1].time - knots[k].time;
    const double middle = knots[k].time + 0.5 * h;
    const auto stepper = odeint::make_controlled(1e-12, 1e-12, odeint::runge_kutta_dopri5<State>());
    odeint::integrate_adaptive(stepper, motion, state, knots[k].time, middle, std::min(0.5 * h, 0.01));
    check_torque(arm, state, torque_at(knots, from, to, middle), middle, complaints);
    odeint::integrate_adaptive(stepper, motion, state, middle, knots[k + 1].time, std::min(0.5 * h, 0.01));
    const Knot& reached = knots[k + 1];
    const double off = std::max(std::abs(state[0] - reached.position), std::abs(state[1] - reached.velocity));
    if (!(off <= kStateTolerance + 1e-12 * std::exp(growth * h))) {
      complaints.push_back(words(arm.name, ": torques lead ", off, " away from the knot at ", reached.time, " s"));
      return;
    }
    if (reached.time - begun < kLongestIntegration) continue;
    state = {reached.position, reached.velocity};
    begun = reached.time;
  }
}

void check_limits(const Arm& arm, const std::vector<Knot>& knots, std::vector<std::string>& complaints) {
  for (const Knot& knot : knots) {
    check_torque(arm, {knot.position, knot.velocity}, knot.torque, knot.time, complaints);
    if (!(knot.velocity >= arm.velocity.lower - kStateTolerance &&
          knot.velocity <= arm.velocity.upper + kStateTolerance)) {
      complaints.push_back(words(arm.name, ": velocity ", knot.velocity, " rad/s at ", knot.time, " s"));
    }
    if (!(knot.position >= arm.joint_range.lower - kStateTolerance &&
          knot.position <= arm.joint_range.upper + kStateTolerance)) {
      complaints.push_back(words(arm.name, ": position ", knot.position, " rad at ", knot.time, " s"));
    }
  }
}

bool has_order(const std::vector<Knot>& knots) {
  return knots.size() >= 2 && knots.front().time == 0.0 &&
         std::is_sorted(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.time < b.time; });
}

void check_arm(const Arm& arm, const Task& task, const ArmTrajectory& motion, std::vector<std::string>& complaints) {
  const std::vector<Knot>& knots = motion.knots;
  const auto is_at = [](const Knot& knot, const JointState& state) {
    return std::abs(knot.position - state.position) <= kStateTolerance &&
           std::abs(knot.velocity - state.velocity) <= kStateTolerance;
  };
  if (!is_at(knots.front(), task.start)) complaints.push_back(arm.name + ": does not begin at its start");
  if (!is_at(knots.back(), task.goal)) complaints.push_back(arm.name + ": does not end at its goal");
  check_limits(arm, knots, complaints);
  std::size_t first = 0;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (knots[k].time > knots[k - 1].time) continue;
    check_dynamics(arm, knots, first, k - 1, complaints);
    if (!is_at(knots[k], {knots[k - 1].position, knots[k - 1].velocity})) {
      complaints.push_back(words(arm.name, ": jumps at ", knots[k].time, " s"));
    }
    first = k;
  }
  check_dynamics(arm, knots, first, knots.size() - 1, complaints);
}

void check_clearance(const Problem& problem, const Trajectory& trajectory, std::vector<std::string>& complaints) {
  if (!complaints.empty()) return;
  const SampledApproach found = sampled_approach(problem, trajectory, kInstants);
  if (found.distance >= problem.options.clearance - kDistanceTolerance && found.distance > kTouching) return;
  complaints.push_back(
      words(found.first_body, " and ", found.second_body, " are ", found.distance, " m apart at ", found.time, " s"));
}

}  // namespace

std::vector<std::string> independent_check(const Problem& problem, const Trajectory& trajectory) {
  for (int i = 0; i < kArmCount; ++i) {
    if (trajectory[i].arm != problem.arms[i].name) return {"trajectories are not in the order of the arms"};
    if (!has_order(trajectory[i].knots)) return {trajectory[i].arm + ": times are not in order"};
  }
  if (trajectory[0].knots.back().time != trajectory[1].knots.back().time) return {"the arms end at different times"};
  std::vector<std::string> complaints;
  for (int i = 0; i < kArmCount; ++i) {
    check_arm(loaded_arm(problem, i), problem.tasks[i], trajectory[i], complaints);
  }
  check_clearance(problem, trajectory, complaints);
  return complaints;
}

}  // namespace dualarm

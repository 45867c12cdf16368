#include "tests/core/verification/sample_motions.h"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "tests/support/problems.h"

namespace dualarm {
namespace {

constexpr double kKnotPeriod = 0.02;  // s

double holding_torque(const Arm& arm, double position) {
  return arm.gravity.amplitude * std::sin(position - arm.gravity.phase);
}

/// Appends an arc of constant acceleration: two knots at least, its first at the time of the last one before.
void add_arc(ArmTrajectory& motion, const Arm& arm, ArcKind kind, Interval time, const JointState& start,
             double acceleration) {
  const int steps = kind == ArcKind::kHold ? 1 : static_cast<int>(std::ceil(time.length() / kKnotPeriod));
  for (int k = 0; k <= steps; ++k) {
    const double since = time.length() * k / steps;
    const double position = start.position + since * (start.velocity + 0.5 * since * acceleration);
    const double at = k == steps ? time.upper : time.lower + since;
    motion.knots.push_back({at, position, start.velocity + since * acceleration, acceleration,
                            arm.inertia * acceleration + holding_torque(arm, position)});
  }
  const Knot& last = motion.knots.back();
  motion.arcs.push_back({kind, time.lower, time.upper, start, {last.position, last.velocity}});
}

double half_time(const Arm& arm, const Task& task) {
  return std::sqrt(std::abs(task.goal.position - task.start.position) * arm.inertia /
                   std::get<Interval>(arm.torque).upper);
}

using LongState = std::array<long double, 2>;

/// One arm under one effort, in long double.
class DrivenArm {
 public:
  DrivenArm(const Arm& arm, Effort effort) : arm_(arm), effort_(effort) {}

  long double acceleration(const LongState& x) const {
    if (effort_ == Effort::kSteady) return 0.0L;
    const Interval limits = torque_limits(arm_.torque, static_cast<double>(x[0]), static_cast<double>(x[1]));
    return ((effort_ == Effort::kUpward ? limits.upper : limits.lower) - resistance(x)) / arm_.inertia;
  }

  Knot knot(double time, const LongState& x) const {
    const long double along = acceleration(x);
    return {time, static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(along),
            static_cast<double>(arm_.inertia * along + resistance(x))};
  }

  LongState after(LongState x, long double duration) const {
    constexpr int kSteps = 4;
    boost::numeric::odeint::runge_kutta_fehlberg78<LongState, long double> stepper;
    const auto motion = [this](const LongState& at, LongState& rate, long double) { rate = {at[1], acceleration(at)}; };
    for (int step = 0; step < kSteps; ++step) stepper.do_step(motion, x, 0.0L, duration / kSteps);
    return x;
  }

  /// How long after x a bend is first crossed, just beyond it; `step` if none is until then.
  long double next_bend(const LongState& x, long double step) const {
    const auto here = cell(x);
    if (cell(after(x, step)) == here) return step;
    long double before = 0.0L;
    for (int i = 0; i < 70; ++i) {
      const long double middle = 0.5L * (before + step);
      (cell(after(x, middle)) == here ? before : step) = middle;
    }
    return step;
  }

 private:
  long double resistance(const LongState& x) const {
    return arm_.gravity.amplitude * std::sin(x[0] - arm_.gravity.phase) + arm_.viscous_friction * x[1];
  }

  std::pair<std::ptrdiff_t, std::ptrdiff_t> cell(const LongState& x) const {
    const auto index = [](const std::vector<double>& bends, long double value) {
      return std::upper_bound(bends.begin(), bends.end(), value) - bends.begin();
    };
    return {index(position_bends(arm_.torque), x[0]), index(velocity_bends(arm_.torque), x[1])};
  }

  const Arm& arm_;
  Effort effort_;
};

}  // namespace

Problem weightless_problem(std::array<double, kArmCount> start_degrees, std::array<double, kArmCount> goal_degrees,
                           double radius, double clearance) {
  Problem problem = paper_problem(start_degrees, goal_degrees, radius, clearance);
  for (Arm& arm : problem.arms) arm.gravity = {};
  return problem;
}

Trajectory parabolic_motion(const Problem& problem, std::array<double, kArmCount> start_times, double duration) {
  for (int i = 0; i < kArmCount; ++i) {
    duration = std::max(duration, start_times[i] + 2.0 * half_time(problem.arms[i], problem.tasks[i]));
  }
  Trajectory trajectory;
  for (int i = 0; i < kArmCount; ++i) {
    const Arm& arm = problem.arms[i];
    const Task& task = problem.tasks[i];
    const double half = half_time(arm, task);
    const double acceleration =
        std::copysign(std::get<Interval>(arm.torque).upper / arm.inertia, task.goal.position - task.start.position);
    const double begin = start_times[i];
    ArmTrajectory& motion = trajectory[i];
    motion.arm = arm.name;
    motion.start_time = begin;
    motion.duration = 2.0 * half;
    if (begin > 0.0) add_arc(motion, arm, ArcKind::kHold, {0.0, begin}, task.start, 0.0);
    if (half > 0.0) {
      add_arc(motion, arm, ArcKind::kAccelerate, {begin, begin + half}, task.start, acceleration);
      add_arc(motion, arm, ArcKind::kBrake, {begin + half, begin + 2.0 * half}, motion.arcs.back().end, -acceleration);
    }
    const double arrival = begin + 2.0 * half;
    if (arrival < duration) add_arc(motion, arm, ArcKind::kHold, {arrival, duration}, task.goal, 0.0);
  }
  return trajectory;
}

Trajectory resting_motion(const Problem& problem, double duration) {
  Trajectory trajectory;
  for (int i = 0; i < kArmCount; ++i) {
    trajectory[i].arm = problem.arms[i].name;
    add_arc(trajectory[i], problem.arms[i], ArcKind::kHold, {0.0, duration}, problem.tasks[i].start, 0.0);
  }
  return trajectory;
}

Trajectory full_torque_motion(Problem& problem, double duration, double knot_period) {
  constexpr int kStepsPerKnot = 50;
  const Arm& arm = problem.arms[0];
  const auto acceleration = [&arm](long double position) {
    return (std::get<Interval>(arm.torque).upper - arm.gravity.amplitude * std::sin(position - arm.gravity.phase)) /
           arm.inertia;
  };
  Trajectory trajectory = resting_motion(problem, duration);
  ArmTrajectory& motion = trajectory[0];
  motion.arcs.clear();
  motion.knots.clear();
  motion.duration = duration;
  long double p = problem.tasks[0].start.position;
  long double v = 0.0L;
  const int knots = static_cast<int>(std::ceil(duration / knot_period));
  const long double h = static_cast<long double>(duration) / knots / kStepsPerKnot;
  for (int k = 0; k <= knots; ++k) {
    motion.knots.push_back({duration * k / knots, static_cast<double>(p), static_cast<double>(v),
                            static_cast<double>(acceleration(p)), std::get<Interval>(arm.torque).upper});
    for (int step = 0; step < kStepsPerKnot && k < knots; ++step) {  // Runge-Kutta-Nystroem, fourth order
      const long double k1 = acceleration(p);
      const long double k2 = acceleration(p + 0.5L * h * v + 0.125L * h * h * k1);
      const long double k3 = acceleration(p + h * v + 0.5L * h * h * k2);
      p += h * v + h * h / 6.0L * (k1 + 2.0L * k2);
      v += h / 6.0L * (k1 + 4.0L * k2 + k3);
    }
  }
  problem.tasks[0].goal = {motion.knots.back().position, motion.knots.back().velocity};
  return trajectory;
}

Trajectory driven_motion(Problem& problem, const std::vector<Stretch>& stretches, double knot_period,
                         bool knots_at_bends) {
  const Arm arm = loaded_arm(problem, 0);
  const JointState& start = problem.tasks[0].start;
  ArmTrajectory motion;
  motion.arm = arm.name;
  LongState x = {start.position, start.velocity};
  long double now = 0.0L;
  for (const Stretch& stretch : stretches) {
    const DrivenArm driven(arm, stretch.effort);
    const long double begin = now;
    const long double end = begin + stretch.duration;
    const LongState from = x;
    motion.knots.push_back(driven.knot(static_cast<double>(now), x));
    while (now < end) {
      const long double steps = std::ceil((end - now) / knot_period - 1e-6L);
      const long double even = (end - now) / std::max(1.0L, steps);
      const long double step = knots_at_bends ? driven.next_bend(x, even) : even;
      x = driven.after(x, step);
      now = steps <= 1.0L && step == even ? end : now + step;
      motion.knots.push_back(driven.knot(static_cast<double>(now), x));
    }
    const ArcKind along =
        from[1] * (stretch.effort == Effort::kUpward ? 1.0L : -1.0L) >= 0.0L ? ArcKind::kAccelerate : ArcKind::kBrake;
    motion.arcs.push_back({stretch.effort == Effort::kSteady ? ArcKind::kCruise : along,
                           static_cast<double>(begin),
                           static_cast<double>(end),
                           {static_cast<double>(from[0]), static_cast<double>(from[1])},
                           {static_cast<double>(x[0]), static_cast<double>(x[1])}});
  }
  motion.duration = motion.knots.back().time;
  problem.tasks[0].goal = {motion.knots.back().position, motion.knots.back().velocity};
  Trajectory trajectory = resting_motion(problem, motion.duration);
  trajectory[0] = motion;
  return trajectory;
}

}  // namespace dualarm

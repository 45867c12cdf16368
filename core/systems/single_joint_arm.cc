#include "core/systems/single_joint_arm.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/model/wide_registers.h"
#include "core/systems/balance.h"
#include "core/systems/torque_shape.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kEverywhere = {-kInfinity, kInfinity};
constexpr std::size_t kMostTerms = 32;  ///< of a series

/// Neighbours whose sines share one call of the library.
constexpr std::size_t kGroup = 16;
using Group = std::array<double, kGroup>;

/// rad. Up to here the first terms left out below, x^13 / 13! and x^14 / 14!, are less than 3e-18.
constexpr double kMostDifference = 0.25;

/// Sines of `about` + x, by the addition theorem.
[[gnu::always_inline]] inline void add_to_sine(double about, const Group& x, Group& sines) {
  using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
  const double s = std::sin(about);
  const double c = std::cos(about);
  for (std::size_t i = 0; i < kGroup; i += 4) {
    Four difference;
    std::memcpy(&difference, &x[i], sizeof difference);
    const Four y = difference * difference;
    const Four sine_less_x =
        difference * y *
        (-1.0 / 6.0 + y * (1.0 / 120.0 + y * (-1.0 / 5040.0 + y * (1.0 / 362880.0 + y * (-1.0 / 39916800.0)))));
    const Four cosine_less_one =
        y * (-0.5 + y * (1.0 / 24.0 +
                         y * (-1.0 / 720.0 + y * (1.0 / 40320.0 + y * (-1.0 / 3628800.0 + y * (1.0 / 479001600.0))))));
    const Four sine = s + (c * (difference + sine_less_x) + s * cosine_less_one);
    std::memcpy(&sines[i], &sine, sizeof sine);
  }
}

/// Sines of the positions of at most kGroup knots, seen from `phase`; nothing where they differ by too much.
std::optional<Group> sines_about_middle(std::span<const Knot> knots, double phase) {
  const double middle = knots[knots.size() / 2].position;
  Group x = {};
  double farthest = 0.0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    x[i] = knots[i].position - middle;
    farthest = std::max(farthest, std::abs(x[i]));
  }
  if (!(farthest <= kMostDifference)) return std::nullopt;
  std::optional<Group> sines(std::in_place);
  with_wide_registers([&] { add_to_sine(middle - phase, x, *sines); });
  return sines;
}

/// The coefficient of time^(k + 1) of the direction e^(i angle), whose derivative is i angle' times itself, from those
/// up to k of it and of the angle's rate. `share` is 1 / (k + 1).
Eigen::Array2d next_direction(const Eigen::Array2d* directions, const double* rates, std::size_t k, double share) {
  // Two sums, since each addition to one waits for the one before; and what is known last comes last.
  Eigen::Array2d even = Eigen::Array2d::Zero();
  Eigen::Array2d odd = Eigen::Array2d::Zero();
  std::size_t j = 1;
  for (; j + 1 < k; j += 2) {
    odd += rates[j] * directions[k - j];
    even += rates[j + 1] * directions[k - j - 1];
  }
  if (j < k) odd += rates[j] * directions[k - j];
  if (k > 0) even += rates[k] * directions[0];
  const Eigen::Array2d sum = (even + odd) + rates[0] * directions[k];
  return {-sum[1] * share, sum[0] * share};
}

}  // namespace

SingleJointArm::SingleJointArm(const Arm& arm)
    : inertia_(arm.inertia),
      friction_(arm.viscous_friction),
      gravity_(arm.gravity),
      torque_(arm.torque),
      range_(arm.joint_range),
      velocity_(arm.velocity),
      at_rest_{torque_at_velocity(torque_, Extreme::kLowest, 0.0, kEverywhere),
               torque_at_velocity(torque_, Extreme::kHighest, 0.0, kEverywhere)},
      velocity_matters_{velocity_dependence(Extreme::kLowest), velocity_dependence(Extreme::kHighest)},
      drives_best_at_rest_{torque_drives_best_at_rest(torque_, friction_, -1.0),
                           torque_drives_best_at_rest(torque_, friction_, 1.0)},
      bounds_{extreme_bound(Extreme::kLowest, velocity_), extreme_bound(Extreme::kHighest, velocity_)},
      rest_bounds_{rest_bound(Extreme::kLowest, bounds_.lower), rest_bound(Extreme::kHighest, bounds_.upper)} {}

Interval SingleJointArm::acceleration(double s, double s_dot) const {
  const double held = gravity_.amplitude * std::sin(s - gravity_.phase) + friction_ * s_dot;
  const auto* constant = std::get_if<Interval>(&torque_);
  const Interval torque = constant != nullptr ? *constant : torque_limits(torque_, s, s_dot);
  return {(torque.lower - held) / inertia_, (torque.upper - held) / inertia_};
}

/// Whether an end depends on the velocity of falling and of rising motions.
std::array<bool, 2> SingleJointArm::velocity_dependence(Extreme extreme) const {
  return {friction_ > 0.0 || torque_depends_on_velocity(torque_, extreme, -1.0),
          friction_ > 0.0 || torque_depends_on_velocity(torque_, extreme, 1.0)};
}

/// At each position the torque that is left runs straight from one bend of the velocities to the next: the bends and
/// the velocity limits have its extremes.
double SingleJointArm::extreme_bound(Extreme extreme, Interval admissible) const {
  std::vector<double> velocities = {0.0};
  if (velocity_matters(extreme, 1.0) || velocity_matters(extreme, -1.0)) {
    velocities = dualarm::velocity_bends(torque_);
    std::erase_if(velocities, [&](double velocity) { return !admissible.contains(velocity); });
    velocities.insert(velocities.end(), {admissible.lower, 0.0, admissible.upper});
  }
  const double sign = extreme == Extreme::kHighest ? 1.0 : -1.0;
  double largest = -kInfinity;  // of sign * torque
  for (const double velocity : velocities) {
    const PiecewiseLinear torque = torque_at_velocity(torque_, extreme, velocity, range_);
    largest = std::max(largest, sign * (extreme_surplus(extreme, torque, gravity_, range_) - rubbed_off(velocity)));
  }
  return sign * largest / inertia_;
}

/// At standstill, from the bound over all velocities where that is the same.
double SingleJointArm::rest_bound(Extreme extreme, double over_velocities) const {
  const bool matters = velocity_matters(extreme, 1.0) || velocity_matters(extreme, -1.0);
  return matters ? extreme_bound(extreme, {0.0, 0.0}) : over_velocities;
}

Interval SingleJointArm::acceleration_bounds(Interval velocities) const {
  if (velocities == Interval{0.0, 0.0}) return rest_bounds_;
  return {extreme_bound(Extreme::kLowest, velocities), extreme_bound(Extreme::kHighest, velocities)};
}

double SingleJointArm::specific_work(Extreme extreme, double from, double change) const {
  // cos(b) - cos(a) as a product of sines: near rest the difference of cosines would lose all digits.
  const double cosine_change = -2.0 * std::sin(from + 0.5 * change - gravity_.phase) * std::sin(0.5 * change);
  return (at_rest_[index(extreme)].integral(from, change) + gravity_.amplitude * cosine_change) / inertia_;
}

std::optional<SineWork> SingleJointArm::work_from(Extreme extreme, double from) const {
  const PiecewiseLinear& torque = at_rest_[index(extreme)];
  if (!torque.is_constant()) return std::nullopt;
  const double gravity = gravity_.amplitude / inertia_;
  const double angle = from - gravity_.phase;
  return SineWork{torque.pieces().front().value / inertia_, gravity * std::sin(angle), gravity * std::cos(angle)};
}

std::vector<double> SingleJointArm::zeros(Extreme extreme, double s_dot, Interval within) const {
  if (!std::holds_alternative<TorqueTable>(torque_)) {
    return balances(torque_end(extreme, torque_limits(torque_, 0.0, s_dot)) - rubbed_off(s_dot), gravity_, within);
  }
  PiecewiseLinear torque = torque_at_velocity(torque_, extreme, s_dot, within);
  torque.add(-rubbed_off(s_dot));
  return balances(torque, gravity_, within);
}

std::vector<double> SingleJointArm::position_bends(Interval within) const {
  return at_rest_[index(Extreme::kLowest)].bends(within);
}

std::vector<double> SingleJointArm::velocity_bends() const { return dualarm::velocity_bends(torque_); }

double SingleJointArm::stiffness() const {
  const double fall =
      std::max(at_rest_[index(Extreme::kLowest)].steepest_fall(), at_rest_[index(Extreme::kHighest)].steepest_fall());
  return (std::abs(gravity_.amplitude) + fall) / inertia_;
}

bool SingleJointArm::extremal_series(Extreme extreme, JointState from, std::span<double> way) const {
  const auto* constant = std::get_if<Interval>(&torque_);
  if (constant == nullptr || way.size() > kMostTerms) return false;
  std::array<Eigen::Array2d, kMostTerms> directions;  // real and imaginary part
  std::array<double, kMostTerms> rate;                // of the angle, which is that of the way
  const double angle = from.position - gravity_.phase;
  directions[0] = {std::cos(angle), std::sin(angle)};
  rate[0] = from.velocity;
  way[0] = 0.0;
  const double per_inertia = 1.0 / inertia_;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    const double share = 1.0 / static_cast<double>(k + 1);
    way[k + 1] = rate[k] * share;
    const double torque =
        (k == 0 ? torque_end(extreme, *constant) : 0.0) - gravity_.amplitude * directions[k][1] - friction_ * rate[k];
    directions[k + 1] = next_direction(directions.data(), rate.data(), k, share);
    rate[k + 1] = torque * per_inertia * share;
  }
  return true;
}

double SingleJointArm::most_sixth_derivative(double speed, double acceleration) const {
  if (!std::holds_alternative<Interval>(torque_)) return kInfinity;
  // Each derivative of the acceleration is that of gravity, by the chain rule, and friction's of the one before.
  const double gravity = std::abs(gravity_.amplitude) / inertia_;
  const double friction = friction_ / inertia_;
  const double squared = speed * speed;
  const double third = gravity * speed + friction * acceleration;
  const double fourth = gravity * (acceleration + squared) + friction * third;
  const double fifth = gravity * (third + 3.0 * speed * acceleration + squared * speed) + friction * fourth;
  return gravity * (fourth + 4.0 * speed * third + 3.0 * acceleration * acceleration + 6.0 * squared * acceleration +
                    squared * squared) +
         friction * fifth;
}

SingleJointArm::Drive SingleJointArm::drive(std::optional<Extreme> extreme, JointState state) const {
  const double held = gravity_.amplitude * std::sin(state.position - gravity_.phase) + rubbed_off(state.velocity);
  const Interval limits = torque_limits(torque_, state.position, state.velocity);
  const double span = limits.length() / inertia_;
  if (!extreme) return {0.0, held, span};
  const double torque = torque_end(*extreme, limits);
  return {(torque - held) / inertia_, torque, span};
}

void SingleJointArm::drive(std::optional<Extreme> extreme, std::span<Knot> knots) const {
  for (std::size_t first = 0; first < knots.size(); first += kGroup) {
    const auto group = knots.subspan(first, std::min(kGroup, knots.size() - first));
    if (drive_together(extreme, group)) continue;
    for (Knot& knot : group) {
      const Drive alone = drive(extreme, {knot.position, knot.velocity});
      knot.acceleration = alone.acceleration;
      knot.torque = alone.torque;
    }
  }
}

/// The same of neighbours; false, and nothing done, where their sines cannot share a call.
bool SingleJointArm::drive_together(std::optional<Extreme> extreme, std::span<Knot> knots) const {
  const auto* constant = std::get_if<Interval>(&torque_);
  if (constant == nullptr) return false;
  const auto sines = sines_about_middle(knots, gravity_.phase);
  if (!sines) return false;
  const double per_inertia = 1.0 / inertia_;
  const double end = extreme ? torque_end(*extreme, *constant) : 0.0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double held = gravity_.amplitude * (*sines)[i] + rubbed_off(knots[i].velocity);
    knots[i].acceleration = extreme ? (end - held) * per_inertia : 0.0;
    knots[i].torque = extreme ? end : held;
  }
  return true;
}

double SingleJointArm::torque(JointState state, double acceleration) const {
  return inertia_ * acceleration + friction_ * state.velocity +
         gravity_.amplitude * std::sin(state.position - gravity_.phase);
}

}  // namespace dualarm

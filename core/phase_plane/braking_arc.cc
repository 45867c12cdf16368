#include "core/phase_plane/braking_arc.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <optional>
#include <utility>

#include "core/phase_plane/crossing.h"

namespace dualarm {
namespace {

/// Error that one step of the integration may make, relative to the range and to the arc's speed: a thousand steps stay
/// below what is promised.
constexpr double kStepTolerance = 1e-13;
/// Share of a natural step below which steps are taken as they are; far shorter than those of the strongest friction on
/// the lightest arm (its time is 1e-21 s).
constexpr double kShortestStep = 1e-30;
constexpr double kFirstStep = 1e-3;  // of a natural step
/// Excess over the speed limit, relative to it, that is rounding: an arc that leaves the limit begins on it.
constexpr double kLimitRounding = 1e-13;
/// Speed, relative to the arc's fastest, that counts as rest: an arc may approach a standstill for ever.
constexpr double kStill = 1e-13;
/// Distance (of the range) from an unstable standstill at which an arc that ends there is begun on its tangent. Errors
/// of the beginning die out along the way back.
constexpr double kBesideStandstill = 1e-7;

using State = std::array<double, 2>;  // x and speed

/// Arc of full braking backwards in time, in steps whose error is controlled.
class Integration {
 public:
  Integration(const OneWay& way, double x, double speed) : way_(way), nodes_{{x, speed}} {
    if (speed <= 0.0 && !(way.braking(x, 0.0) < 0.0)) leave_standstill();
  }

  ArcEnd run() {
    double step = kFirstStep * natural_step(nodes_.back());
    for (;;) {
      step = advance(step);
      if (const auto end = event()) return *end;
    }
  }

  double lower_end() const { return nodes_.back()[0]; }

  double speed_at(double x) const {
    const auto below = std::lower_bound(nodes_.begin(), nodes_.end(), x,
                                        [](const State& node, double value) { return node[0] > value; });
    if (below == nodes_.begin()) return nodes_.front()[1];
    if (below == nodes_.end()) return nodes_.back()[1];
    const State& from = *(below - 1);
    const double step = steps_[static_cast<std::size_t>(below - nodes_.begin()) - 1];
    if (step == 0.0) return std::lerp(from[1], (*below)[1], (from[0] - x) / (from[0] - (*below)[0]));
    const auto beyond = [&](double part) { return after(from, part)[0] - x; };
    if (beyond(step) >= 0.0) return (*below)[1];  // an end that was cut to the bit
    return after(from, crossing(beyond, 0.0, step))[1];
  }

 private:
  double length() const { return way_.range().length(); }

  /// Time in which a state would cross the range.
  double natural_step(const State& state) const {
    return length() / (state[1] + std::sqrt(length() * std::abs(way_.braking(state[0], state[1]))));
  }

  State after(const State& from, double step) const { return stepped(from, step).first; }

  /// State a `step` earlier, and the estimate of its error.
  std::pair<State, State> stepped(const State& from, double step) const {
    boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
    const auto rate_of = [this](const State& state, State& rate, double) {
      rate = {-state[1], -way_.braking(state[0], state[1])};
    };
    State reached = from;
    State error = {0.0, 0.0};
    stepper.do_step(rate_of, reached, 0.0, step, error);
    return {reached, error};
  }

  /// Adds a node; returns the step to try next.
  double advance(double step) {
    const State from = nodes_.back();
    const double shortest = kShortestStep * natural_step(from);
    for (;;) {
      const auto [reached, error] = stepped(from, step);
      const double speed = std::max({fastest_, std::abs(from[1]), std::abs(reached[1])});
      const double size = std::max(std::abs(error[0]) / length(), std::abs(error[1]) / speed) / kStepTolerance;
      const double growth =
          std::isfinite(size) ? std::clamp(0.9 * std::pow(std::max(size, 1e-30), -0.125), 0.2, 4.0) : 0.01;
      if (size <= 1.0 || step <= shortest) {
        fastest_ = speed;
        nodes_.push_back(reached);
        steps_.push_back(step);
        return std::max(shortest, std::min(step * growth, 0.1 * natural_step(reached)));
      }
      step *= growth;
    }
  }

  /// Cuts the last step short where it passes an end.
  std::optional<ArcEnd> event() {
    const State from = nodes_[nodes_.size() - 2];
    std::optional<ArcEnd> end;
    const auto cut_at = [&](ArcEnd here, std::size_t coordinate, double value) {
      const double step =
          crossing([&](double part) { return after(from, part)[coordinate] - value; }, 0.0, steps_.back());
      steps_.back() = step;
      nodes_.back() = after(from, step);
      nodes_.back()[coordinate] = value;
      end = here;
    };
    if (nodes_.back()[0] < way_.range().lower) cut_at(ArcEnd::kRange, 0, way_.range().lower);
    if (nodes_.back()[1] > (1.0 + kLimitRounding) * way_.speed_limit())
      cut_at(ArcEnd::kSpeedLimit, 1, way_.speed_limit());
    if (nodes_.back()[1] < 0.0) cut_at(ArcEnd::kRest, 1, 0.0);
    if (!end && nodes_.back()[1] < kStill * fastest_) end = ArcEnd::kRest;
    return end;
  }

  /// The arc comes into the standstill along the stable one of its two tangents, speed = rate * distance.
  void leave_standstill() {
    const double x = nodes_.front()[0];
    const double apart = kBesideStandstill * length();
    const double by_position = -way_.braking(x - apart, 0.0) / apart;
    const double speed = apart * std::sqrt(std::max(by_position, 0.0));
    const double by_speed = speed > 0.0 ? (way_.braking(x, speed) - way_.braking(x, 0.0)) / speed : 0.0;
    const double rate = 0.5 * (-by_speed + std::sqrt(by_speed * by_speed + 4.0 * std::max(by_position, 0.0)));
    nodes_.push_back({x - apart, rate * apart});
    steps_.push_back(0.0);
  }

  const OneWay& way_;
  std::vector<State> nodes_;   // x descends
  std::vector<double> steps_;  // s, from each node to the next; 0 where it is a straight line
  double fastest_ = 0.0;
};

BrakingArc integrated_arc(const OneWay& way, double x, double speed) {
  Integration integration(way, x, speed);
  const ArcEnd end = integration.run();
  return {{integration.lower_end(), x, [integration](double at) { return integration.speed_at(at); }}, end};
}

BrakingArc worked_arc(const OneWay& way, double x, double speed) {
  const double energy = 0.5 * speed * speed;
  const double limit = 0.5 * way.speed_limit() * way.speed_limit();
  const auto energy_at = [&way, x, energy](double at) { return energy + way.work(x, at - x); };
  BrakingArc arc;
  arc.curve = {way.range().lower, x, [energy_at](double at) { return std::sqrt(2.0 * std::max(energy_at(at), 0.0)); }};
  const std::vector<double> cuts = way.cuts(0.0, {way.range().lower, x});  // in between the energy is monotone
  for (std::size_t i = cuts.size() - 1; i > 0; --i) {
    const double before = energy_at(cuts[i - 1]);
    if (before <= limit && before >= 0.0) continue;
    const double bound = before > limit ? limit : 0.0;
    arc.end = before > limit ? ArcEnd::kSpeedLimit : ArcEnd::kRest;
    arc.curve.from = crossing([&](double at) { return energy_at(at) - bound; }, cuts[i - 1], cuts[i]);
    break;
  }
  return arc;
}

}  // namespace

OneWay::OneWay(const System& system, double direction)
    : system_(system),
      direction_(direction),
      extreme_(direction > 0.0 ? Extreme::kLowest : Extreme::kHighest),
      range_(direction > 0.0 ? system.range() : Interval{-system.range().upper, -system.range().lower}),
      limit_(direction > 0.0 ? system.velocity().upper : -system.velocity().lower),
      matters_(system.velocity_matters(extreme_, direction)) {}

double OneWay::braking(double x, double speed) const {
  return direction_ * system_.extreme_acceleration(extreme_, direction_ * x, direction_ * speed);
}

double OneWay::work(double x, double change) const {
  return system_.specific_work(extreme_, direction_ * x, direction_ * change);
}

std::vector<double> OneWay::cuts(double speed, Interval within) const {
  const Interval positions = direction_ > 0.0 ? within : Interval{-within.upper, -within.lower};
  std::vector<double> cuts = {within.lower, within.upper};
  for (const double zero : system_.zeros(extreme_, direction_ * speed, positions)) cuts.push_back(direction_ * zero);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

BrakingArc braking_arc_before(const OneWay& way, double x, double speed) {
  return way.speed_matters() ? integrated_arc(way, x, speed) : worked_arc(way, x, speed);
}

}  // namespace dualarm

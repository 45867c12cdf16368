#include "core/verification/interpolant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

/// Infinite where a value is not a number, so that nothing is proven with it.
template <std::size_t kSize>
double largest_magnitude(const std::array<double, kSize>& values) {
  double most = 0.0;
  for (double value : values) {
    if (!(std::abs(value) <= most))
      most = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::abs(value);
  }
  return most;
}

/// Bernstein coefficients of the derivative from those of a polynomial over `duration`.
template <std::size_t kSize>
std::array<double, kSize - 1> differentiated(const std::array<double, kSize>& bernstein, double duration) {
  std::array<double, kSize - 1> derivative;
  for (std::size_t i = 0; i + 1 < kSize; ++i) {
    derivative[i] = static_cast<double>(kSize - 1) * (bernstein[i + 1] - bernstein[i]) / duration;
  }
  return derivative;
}

/// What the derivative of an order makes of a power: power (power - 1) ... (power - order + 1).
constexpr std::array<std::array<double, 6>, 6> kFalling = {{{1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
                                                            {0.0, 1.0, 2.0, 3.0, 4.0, 5.0},
                                                            {0.0, 0.0, 2.0, 6.0, 12.0, 20.0},
                                                            {0.0, 0.0, 0.0, 6.0, 24.0, 60.0},
                                                            {0.0, 0.0, 0.0, 0.0, 24.0, 120.0},
                                                            {0.0, 0.0, 0.0, 0.0, 0.0, 120.0}}};

constexpr std::size_t kBlockSize = 256;  // pieces

}  // namespace

bool share_a_time(const Knot& before, const Knot& after) {
  const double last_digits = kSameTimeDigits * std::numeric_limits<double>::epsilon() * after.time;
  return after.time - before.time <= std::max(kSameTime, last_digits);
}

Quintic::Quintic(const Knot& start, const Knot& end) : start_(start.time), duration_(end.time - start.time) {
  const double h = duration_;
  const double change = end.position - start.position;
  const double v0 = start.velocity;
  const double v1 = end.velocity;
  const double a0 = start.acceleration;
  const double a1 = end.acceleration;

  // What the parabola of the start leaves of position, velocity and acceleration at the end, in units of position.
  const double p = change - h * v0 - 0.5 * h * h * a0;
  const double v = h * (v1 - v0) - h * h * a0;
  const double a = 0.5 * h * h * (a1 - a0);
  coefficients_ = {
      start.position,       h * v0, 0.5 * h * h * a0, 10.0 * p - 4.0 * v + a, -15.0 * p + 7.0 * v - 2.0 * a,
      6.0 * p - 3.0 * v + a};

  // A polynomial lies between the least and the largest of its Bernstein coefficients. Velocity and acceleration are
  // written out, because differences of the position's coefficients lose digits over short times.
  const std::array<double, 5> velocity = {
      v0, v0 + 0.25 * h * a0, 5.0 * change / h - 2.0 * (v0 + v1) + 0.25 * h * (a1 - a0), v1 - 0.25 * h * a1, v1};
  const std::array<double, 4> acceleration = {a0, 20.0 * (change / h - 0.6 * v0 - 0.4 * v1) / h + a1 - 2.0 * a0,
                                              20.0 * (0.4 * v0 + 0.6 * v1 - change / h) / h + a0 - 2.0 * a1, a1};
  const std::array<double, 3> jerk = differentiated(acceleration, h);
  const std::array<double, 2> snap = differentiated(jerk, h);
  const std::array<double, 1> crackle = differentiated(snap, h);
  most_ = {0.0,
           largest_magnitude(velocity),
           largest_magnitude(acceleration),
           largest_magnitude(jerk),
           largest_magnitude(snap),
           largest_magnitude(crackle)};

  // Half a last digit of both positions, both velocities and both times. The second derivative of the quintic answers
  // a change of one position by at most 5.8 / h^2 and of one velocity by at most 4 / h; the first by 1.9 / h and 1.
  const double half_digit = 0.5 * std::numeric_limits<double>::epsilon();
  const double times = std::abs(start.time) + std::abs(end.time);
  const double of_position =
      half_digit * (std::abs(start.position) + std::abs(end.position) + std::max(std::abs(v0), std::abs(v1)) * times);
  const double of_velocity = half_digit * (std::abs(v0) + std::abs(v1) + (std::abs(a0) + std::abs(a1)) * times);
  velocity_rounding_ = 2.0 * of_position / h + of_velocity;
  acceleration_rounding_ = 6.0 * of_position / (h * h) + 4.0 * of_velocity / h;
}

double Quintic::derivative(int order, double time) const {
  const double u = std::clamp((time - start_) / duration_, 0.0, 1.0);
  double value = 0.0;
  for (int power = 5; power >= order; --power) value = value * u + kFalling[order][power] * coefficients_[power];
  for (int i = 0; i < order; ++i) value /= duration_;
  return value;
}

Interval Quintic::range(int order) const {
  const double start = derivative(order, start_);
  const double end = derivative(order, start_ + duration_);
  const double departure = most_[order + 2] * duration_ * duration_ / 8.0;
  return {std::min(start, end) - departure, std::max(start, end) + departure};
}

std::array<double, 6> Quintic::in_the_middle() const {
  // Horner's scheme again and again: the coefficients of powers of the way from the middle.
  std::array<double, 6> shifted = coefficients_;
  for (int first = 0; first < 5; ++first) {
    for (int power = 4; power >= first; --power) shifted[power] += 0.5 * shifted[power + 1];
  }
  double factor = 1.0;
  for (int order = 1; order <= 5; ++order) {
    factor *= order / duration_;
    shifted[order] *= factor;
  }
  return shifted;
}

Interpolant::Interpolant(const std::vector<Knot>& knots)
    : start_{knots.front().position, knots.front().velocity}, end_{knots.back().position, knots.back().velocity} {
  pieces_.reserve(knots.size());
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    if (!share_a_time(knots[k], knots[k + 1])) pieces_.emplace_back(knots[k], knots[k + 1]);
  }
  summarise();
}

void Interpolant::summarise() {
  blocks_.resize(pieces_.size() / kBlockSize);
  for (std::size_t i = 0; i < blocks_.size() * kBlockSize; ++i) {
    Block& block = blocks_[i / kBlockSize];
    block.travel += pieces_[i].most(1) * pieces_[i].duration();
    block.most.speed = std::max(block.most.speed, pieces_[i].most(1));
    block.most.acceleration = std::max(block.most.acceleration, pieces_[i].most(2));
  }
}

template <typename VisitPiece, typename VisitBlock>
void Interpolant::walk(Interval time, VisitPiece visit_piece, VisitBlock visit_block) const {
  for (std::size_t i = piece_at(time.lower); i < pieces_.size() && pieces_[i].time().lower <= time.upper;) {
    const std::size_t block = i / kBlockSize;
    const bool is_whole = i % kBlockSize == 0 && block < blocks_.size() && time.lower <= pieces_[i].time().lower &&
                          pieces_[i + kBlockSize - 1].time().upper <= time.upper;
    if (is_whole) {
      visit_block(blocks_[block]);
    } else {
      visit_piece(pieces_[i]);
    }
    i += is_whole ? kBlockSize : 1;
  }
}

std::size_t Interpolant::piece_at(double time) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](double t, const Quintic& piece) { return t < piece.time().lower; });
  return after == pieces_.begin() ? 0 : static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

JointState Interpolant::state(double time) const {
  if (pieces_.empty() || time <= pieces_.front().time().lower) return start_;
  if (time >= pieces_.back().time().upper) return end_;
  const Quintic& piece = pieces_[piece_at(time)];
  return {piece.derivative(0, time), piece.derivative(1, time)};
}

double Interpolant::travel(Interval time) const {
  double way = 0.0;
  const auto add_piece = [&](const Quintic& piece) {
    const Interval its = piece.time();
    way += piece.most(1) * std::max(0.0, std::min(its.upper, time.upper) - std::max(its.lower, time.lower));
  };
  walk(time, add_piece, [&](const Block& block) { way += block.travel; });
  return way;
}

Interpolant::Bounds Interpolant::bounds(Interval time) const {
  Bounds most;
  if (pieces_.empty() || time.lower >= pieces_.back().time().upper) return most;
  const auto include = [&most](double speed, double acceleration) {
    most.speed = std::max(most.speed, speed);
    most.acceleration = std::max(most.acceleration, acceleration);
  };
  walk(
      time, [&](const Quintic& piece) { include(piece.most(1), piece.most(2)); },
      [&](const Block& block) { include(block.most.speed, block.most.acceleration); });
  return most;
}

}  // namespace dualarm

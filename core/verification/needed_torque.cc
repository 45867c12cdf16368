#include "core/verification/needed_torque.h"

#include <cmath>
#include <limits>

#include "core/verification/lanes.h"
#include "core/verification/sines.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What quintic interpolation of both ends leaves of a function's sixth derivative: h^6 / (6! 2^6).
constexpr double kInterpolationPart = 1.0 / 46080.0;

/// Bound on the sixth derivative of the sine of an angle whose own sixth is nothing, from bounds on its derivatives
/// v, a, j, s and c of order 1 to 5, all times that power of a time. Faa di Bruno:
///   6 c v + 15 s (a + v^2) + 10 j^2 + 60 j a v + 20 j v^3 + 15 a^3 + 45 a^2 v^2 + 15 a v^4 + v^6, or less.
template <typename Number>
[[gnu::always_inline]] inline Number most_sixth_of_sine(const Number& v, const Number& a, const Number& j,
                                                        const Number& s, const Number& c) {
  const Number both = a + v * v;
  return 6.0 * c * v + 15.0 * s * both + j * (10.0 * j + 60.0 * v * both) + 15.0 * both * both * both;
}

/// Where the numbers of the pieces of a run stand.
struct Columns {
  const double* acceleration;
  const double* torque;
  const double* rate;
  const double* curvature;
  const double* duration;
  const double* second;
  const double* third;
  const double* speed;
  const double* most_acceleration;
  double* lowest;
  double* highest;
  double* departure;
};

/// What is gathered over all pieces.
struct Gathered {
  Lanes lowest = Lanes() + kInfinity;
  Lanes highest = Lanes() - kInfinity;
  Lanes doubt = Lanes();  // 0 while all numbers are finite
};

template <typename Number>
[[gnu::always_inline]] inline void bound_piece(const JointTorque& torque, const Columns& columns, std::size_t i,
                                               Gathered& all) {
  const Number h = load<Number>(columns.duration + i);
  const Number second = load<Number>(columns.second + i);
  const Number third = load<Number>(columns.third + i);
  const Number first_step = second - load<Number>(columns.acceleration + i);
  const Number middle_step = third - second;
  const Number last_step = load<Number>(columns.acceleration + i + 1) - third;
  const Number square = h * h;
  const Number first_bend = middle_step - first_step;
  const Number last_bend = last_step - middle_step;

  const Number most_sixth = most_sixth_of_sine<Number>(
      h * load<Number>(columns.speed + i), square * load<Number>(columns.most_acceleration + i),
      3.0 * square *
          greater<Number>(greater<Number>(magnitude<Number>(first_step), magnitude<Number>(middle_step)),
                          magnitude<Number>(last_step)),
      6.0 * square * greater<Number>(magnitude<Number>(first_bend), magnitude<Number>(last_bend)),
      6.0 * square * magnitude<Number>(last_bend - first_bend));
  const Number remainder = kInterpolationPart * std::abs(torque.gravity_amplitude()) * most_sixth;

  // Bernstein coefficients less the torque of the nearer knot: of the acceleration's from degree three to five, of the
  // others' from their derivatives.
  const Number of_friction = 0.15 * torque.friction() * h;
  const Number start_rate = 0.2 * h * load<Number>(columns.rate + i);
  const Number end_rate = 0.2 * h * load<Number>(columns.rate + i + 1);
  const Number twentieth = 0.05 * square;
  const Number inertia = Number() + torque.inertia();
  const Number c1 = 0.6 * inertia * first_step + start_rate;
  const Number c2 = inertia * (0.9 * first_step + 0.3 * middle_step) + of_friction * first_step + 2.0 * start_rate +
                    twentieth * load<Number>(columns.curvature + i);
  const Number c3 = -inertia * (0.9 * last_step + 0.3 * middle_step) + of_friction * last_step - 2.0 * end_rate +
                    twentieth * load<Number>(columns.curvature + i + 1);
  const Number c4 = -0.6 * inertia * last_step - end_rate;

  const Number start = load<Number>(columns.torque + i);
  const Number end = load<Number>(columns.torque + i + 1);
  const Number nothing = Number();
  const Number lowest = lesser<Number>(start + lesser<Number>(lesser<Number>(c1, c2), nothing),
                                       end + lesser<Number>(lesser<Number>(c3, c4), nothing)) -
                        remainder;
  const Number highest = greater<Number>(start + greater<Number>(greater<Number>(c1, c2), nothing),
                                         end + greater<Number>(greater<Number>(c3, c4), nothing)) +
                         remainder;
  const Number step = 0.2 * (end - start);
  const Number departure =
      greater<Number>(greater<Number>(magnitude<Number>(c1 - step), magnitude<Number>(c2 - 2.0 * step)),
                      greater<Number>(magnitude<Number>(c3 + 2.0 * step), magnitude<Number>(c4 + step))) +
      remainder;
  const Number sum = (start + end) + (c1 + c2) + (c3 + c4) + remainder;
  const Number doubt = sum - sum;  // not a number where one of them is not finite
  store<Number>(columns.lowest + i, lowest + doubt);
  store<Number>(columns.highest + i, highest + doubt);
  store<Number>(columns.departure + i, departure + doubt);
  all.lowest = lesser<Lanes>(all.lowest, widened(lowest));
  all.highest = greater<Lanes>(all.highest, widened(highest));
  all.doubt = all.doubt + widened(doubt);
}

}  // namespace

NeededTorque::NeededTorque(const JointTorque& torque, const Interpolant& motion)
    : knots_(static_cast<Eigen::Index>(motion.times().size()), 3),
      pieces_(static_cast<Eigen::Index>(motion.piece_count()), 3) {
  take_knots(torque, motion);
  bound_pieces(torque, motion);
}

void NeededTorque::take_knots(const JointTorque& torque, const Interpolant& motion) {
  const std::span<const double> positions = motion.positions();
  const double* const velocity = motion.velocities().data();
  const double* const acceleration = motion.accelerations().data();
  Eigen::ArrayXd angles = Eigen::Map<const Eigen::ArrayXd>(positions.data(), knots_.rows()) - torque.gravity_phase();
  const Eigen::ArrayX2d trigonometry = sines_and_cosines({angles.data(), positions.size()});
  const double* const sine = trigonometry.col(0).data();
  const double* const cosine = trigonometry.col(1).data();
  double* const needed = knots_.col(0).data();
  double* const rate = knots_.col(1).data();
  double* const curvature = knots_.col(2).data();
  for_lanes(
      positions.size(), [&]<typename Number>(std::size_t k) __attribute__((always_inline)) {
        const Number v = load<Number>(velocity + k);
        const Number a = load<Number>(acceleration + k);
        const Number of_sine = torque.gravity_amplitude() * load<Number>(sine + k);
        const Number of_cosine = torque.gravity_amplitude() * load<Number>(cosine + k);
        store<Number>(needed + k, torque.inertia() * a + of_sine + torque.friction() * v);
        store<Number>(rate + k, of_cosine * v + torque.friction() * a);
        store<Number>(curvature + k, of_cosine * a - of_sine * v * v);
      });
}

void NeededTorque::bound_pieces(const JointTorque& torque, const Interpolant& motion) {
  Gathered all;
  for (const Interpolant::Run& run : motion.runs()) {
    const auto of_knots = [&](Eigen::Index column) { return knots_.col(column).data() + run.first_knot; };
    const auto of_pieces = [&](Eigen::Index column) { return pieces_.col(column).data() + run.first_piece; };
    const Columns columns = {motion.accelerations().data() + run.first_knot,
                             of_knots(0),
                             of_knots(1),
                             of_knots(2),
                             motion.durations().data() + run.first_piece,
                             motion.second_accelerations().data() + run.first_piece,
                             motion.third_accelerations().data() + run.first_piece,
                             motion.speeds().data() + run.first_piece,
                             motion.most_accelerations().data() + run.first_piece,
                             of_pieces(0),
                             of_pieces(1),
                             of_pieces(2)};
    gather_lanes(
        run.piece_count, all, [&]<typename Number>(std::size_t i, Gathered & so_far) __attribute__((always_inline)) {
          bound_piece<Number>(torque, columns, i, so_far);
        });
  }
  const bool is_finite = sum_of(all.doubt) == 0.0;
  range_ = is_finite ? Interval{least_of(all.lowest), most_of(all.highest)} : Interval{-kInfinity, kInfinity};
}

}  // namespace dualarm

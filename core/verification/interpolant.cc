#include "core/verification/interpolant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "core/verification/lanes.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBlockSize = 16;  // pieces

/// What is gathered over all pieces.
struct Gathered {
  Lanes lowest = Lanes() + kInfinity;
  Lanes highest = Lanes() - kInfinity;
  Lanes slowest = Lanes() + kInfinity;
  Lanes fastest = Lanes() - kInfinity;
  Lanes doubt = Lanes();  // 0 while all numbers are finite
};

/// Where the numbers of the pieces of a run stand.
struct Columns {
  const double* time;
  const double* position;
  const double* velocity;
  const double* acceleration;
  double* start;
  double* duration;
  double* second;
  double* third;
  double* lowest;
  double* highest;
  double* slowest;
  double* fastest;
  double* speed;
  double* most_acceleration;
};

/// Bernstein coefficients of the position, and the pieces' bounds from them. `y` is a twentieth of the square of h.
template <typename Number>
[[gnu::always_inline]] inline void bound_position(const Columns& columns, std::size_t i, const Number& h,
                                                  Gathered& all) {
  const Number q0 = load<Number>(columns.position + i);
  const Number q1 = load<Number>(columns.position + i + 1);
  const Number x0 = 0.2 * h * load<Number>(columns.velocity + i);
  const Number x1 = 0.2 * h * load<Number>(columns.velocity + i + 1);
  const Number y0 = 0.05 * h * h * load<Number>(columns.acceleration + i);
  const Number y1 = 0.05 * h * h * load<Number>(columns.acceleration + i + 1);
  const Number second = q0 + x0;
  const Number third = q0 + 2.0 * x0 + y0;
  const Number fourth = q1 - 2.0 * x1 + y1;
  const Number fifth = q1 - x1;
  const Number lowest = lesser<Number>(lesser<Number>(lesser<Number>(q0, q1), lesser<Number>(second, third)),
                                       lesser<Number>(fourth, fifth));
  const Number highest = greater<Number>(greater<Number>(greater<Number>(q0, q1), greater<Number>(second, third)),
                                         greater<Number>(fourth, fifth));
  store<Number>(columns.lowest + i, lowest);
  store<Number>(columns.highest + i, highest);
  all.lowest = lesser<Lanes>(all.lowest, widened(lowest));
  all.highest = greater<Lanes>(all.highest, widened(highest));
  const Number sum = second + third + fourth + fifth;
  all.doubt = all.doubt + widened(Number(sum - sum));
}

/// The same of velocity and acceleration. They are written out, because differences of the position's coefficients lose
/// digits over short times.
template <typename Number>
[[gnu::always_inline]] inline void bound_rates(const Columns& columns, std::size_t i, const Number& h, Gathered& all) {
  const Number per = 1.0 / h;
  const Number mean = (load<Number>(columns.position + i + 1) - load<Number>(columns.position + i)) * per;
  const Number v0 = load<Number>(columns.velocity + i);
  const Number v4 = load<Number>(columns.velocity + i + 1);
  const Number a0 = load<Number>(columns.acceleration + i);
  const Number a3 = load<Number>(columns.acceleration + i + 1);
  const Number v1 = v0 + 0.25 * h * a0;
  const Number v2 = 5.0 * mean - 2.0 * (v0 + v4) + 0.25 * h * (a3 - a0);
  const Number v3 = v4 - 0.25 * h * a3;
  const Number slowest = lesser<Number>(lesser<Number>(lesser<Number>(v0, v1), lesser<Number>(v3, v4)), v2);
  const Number fastest = greater<Number>(greater<Number>(greater<Number>(v0, v1), greater<Number>(v3, v4)), v2);
  const Number speed = greater<Number>(fastest, -slowest);
  const Number a1 = 20.0 * (mean - 0.6 * v0 - 0.4 * v4) * per + a3 - 2.0 * a0;
  const Number a2 = 20.0 * (0.4 * v0 + 0.6 * v4 - mean) * per + a0 - 2.0 * a3;
  const Number most_acceleration = greater<Number>(greater<Number>(magnitude<Number>(a0), magnitude<Number>(a1)),
                                                   greater<Number>(magnitude<Number>(a2), magnitude<Number>(a3)));
  store<Number>(columns.slowest + i, slowest);
  store<Number>(columns.fastest + i, fastest);
  store<Number>(columns.speed + i, speed);
  store<Number>(columns.second + i, a1);
  store<Number>(columns.third + i, a2);
  store<Number>(columns.most_acceleration + i, most_acceleration);

  all.slowest = lesser<Lanes>(all.slowest, widened(slowest));
  all.fastest = greater<Lanes>(all.fastest, widened(fastest));
  const Number sum = (a1 + a2) + (v1 + v2 + v3);
  all.doubt = all.doubt + widened(Number(sum - sum));
}

template <typename Number>
[[gnu::always_inline]] inline void bound_piece(const Columns& columns, std::size_t i, Gathered& all) {
  const Number time = load<Number>(columns.time + i);
  const Number h = load<Number>(columns.time + i + 1) - time;
  store<Number>(columns.start + i, time);
  store<Number>(columns.duration + i, h);
  bound_position(columns, i, h, all);
  bound_rates(columns, i, h, all);
}

/// Time, position, velocity and acceleration of a knot.
[[gnu::always_inline]] inline Lanes state_of(const Knot& knot) {
  static_assert(offsetof(Knot, time) == 0 && offsetof(Knot, acceleration) == (kLaneCount - 1) * sizeof(double));
  Lanes state;
  std::memcpy(&state, &knot, sizeof state);
  return state;
}

/// Writes these of all knots as columns, one after the other.
[[gnu::always_inline]] inline void transpose(const std::vector<Knot>& knots, double* columns) {
  const std::size_t count = knots.size();
  std::size_t k = 0;
  for (; k + kLaneCount <= count; k += kLaneCount) {
    const Lanes a = state_of(knots[k]);
    const Lanes b = state_of(knots[k + 1]);
    const Lanes c = state_of(knots[k + 2]);
    const Lanes d = state_of(knots[k + 3]);
    const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    store<Lanes>(columns + k, __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5));
    store<Lanes>(columns + count + k, __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5));
    store<Lanes>(columns + 2 * count + k, __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7));
    store<Lanes>(columns + 3 * count + k, __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7));
  }
  for (; k < count; ++k) {
    const Lanes state = state_of(knots[k]);
    for (std::size_t column = 0; column < kLaneCount; ++column) columns[column * count + k] = state[column];
  }
}

}  // namespace

Interpolant::Interpolant(const std::vector<Knot>& knots)
    : knots_(static_cast<Eigen::Index>(knots.size()), static_cast<Eigen::Index>(kKnotColumns)),
      position_range_{kInfinity, -kInfinity},
      velocity_range_{kInfinity, -kInfinity} {
  take(knots);
  pieces_.resize(static_cast<Eigen::Index>(piece_count_), static_cast<Eigen::Index>(kPieceColumns));
  bound_pieces();
  summarise();
}

void Interpolant::take(const std::vector<Knot>& knots) {
  static_assert(kTime == 0 && kPosition == 1 && kVelocity == 2 && kAcceleration == 3);
  with_wide_registers([&] { transpose(knots, knots_.data()); });
  const double* const time = times().data();
  std::size_t first = 0;
  const auto end_run = [&](std::size_t last) {
    if (last > first) runs_.push_back({first, piece_count_, last - first});
    piece_count_ += last - first;
    first = last + 1;
  };
  const std::size_t count = knots.size();
  for (std::size_t k = 1; k < count; ++k) {
    if (share_a_time(time[k - 1], time[k])) end_run(k - 1);
  }
  end_run(knots.size() - 1);
}

void Interpolant::bound_pieces() {
  Gathered all;
  for (const Run& run : runs_) {
    const auto of_knots = [&](KnotColumn column) { return knots_.col(column).data() + run.first_knot; };
    const auto of_pieces = [&](PieceColumn column) { return pieces_.col(column).data() + run.first_piece; };
    const Columns columns = {of_knots(kTime),         of_knots(kPosition),         of_knots(kVelocity),
                             of_knots(kAcceleration), of_pieces(kStart),           of_pieces(kDuration),
                             of_pieces(kSecond),      of_pieces(kThird),           of_pieces(kLowest),
                             of_pieces(kHighest),     of_pieces(kSlowest),         of_pieces(kFastest),
                             of_pieces(kSpeed),       of_pieces(kMostAcceleration)};
    gather_lanes(
        run.piece_count, all, [&]<typename Number>(std::size_t i, Gathered & so_far) __attribute__((always_inline)) {
          bound_piece<Number>(columns, i, so_far);
        });
  }
  position_range_ = {least_of(all.lowest), most_of(all.highest)};
  velocity_range_ = {least_of(all.slowest), most_of(all.fastest)};
  if (!(sum_of(all.doubt) == 0.0)) overflow();
}

/// Nothing is proven of pieces with numbers that are not finite, nor of all together.
void Interpolant::overflow() {
  for (Eigen::Index i = 0; i < pieces_.rows(); ++i) {
    if (pieces_.row(i).segment(kSecond, kMostAcceleration - kSecond + 1).isFinite().all()) continue;
    for (const auto lower : {kLowest, kSlowest}) pieces_(i, lower) = -kInfinity;
    for (const auto upper : {kHighest, kFastest, kSpeed, kMostAcceleration}) pieces_(i, upper) = kInfinity;
  }
  position_range_ = velocity_range_ = {-kInfinity, kInfinity};
}

void Interpolant::summarise() {
  const auto speed = pieces_.col(kSpeed);
  const auto acceleration = pieces_.col(kMostAcceleration);
  double way = 0.0;
  for (Eigen::Index i = 0; i < pieces_.rows(); ++i) {
    way += speed[i] * pieces_(i, kDuration);
    pieces_(i, kTravelled) = way;
  }
  constexpr auto kSize = static_cast<Eigen::Index>(kBlockSize);
  blocks_.resize(pieces_.rows() / kSize, 2);
  for (Eigen::Index block = 0; block < blocks_.rows(); ++block) {
    blocks_(block, 0) = speed.segment<kSize>(block * kSize).maxCoeff();
    blocks_(block, 1) = acceleration.segment<kSize>(block * kSize).maxCoeff();
  }
}

std::size_t Interpolant::knot_before(std::size_t piece) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), piece,
                                      [](std::size_t index, const Run& run) { return index < run.first_piece; });
  return (after - 1)->first_knot + (piece - (after - 1)->first_piece);
}

Knot Interpolant::knot(std::size_t index) const {
  return {times()[index], positions()[index], velocities()[index], accelerations()[index], 0.0};
}

Quintic Interpolant::piece(std::size_t index) const {
  const std::size_t before = knot_before(index);
  return {knot(before), knot(before + 1)};
}

/// The last piece that begins by a time, or the first one. Pieces of a run mostly have nearly the same duration: that
/// tells where to look first, and from there in steps twice as long each time.
std::size_t Interpolant::piece_at(double time) const {
  const std::span<const double> starts = of_pieces(kStart);
  std::size_t run = runs_.size() - 1;
  while (run > 0 && !(starts[runs_[run].first_piece] <= time)) --run;
  const auto [first_knot, first, count] = runs_[run];
  const double begin = times()[first_knot];
  const double part = (time - begin) / (times()[first_knot + count] - begin);
  const std::size_t end = first + count;
  // Written so that what is not a number leads to the first piece.
  const std::size_t guess = !(part > 0.0) ? first
                            : part >= 1.0 ? end - 1
                                          : first + static_cast<std::size_t>(part * static_cast<double>(count));
  std::size_t low = std::min(guess, end - 1);
  std::size_t high = low + 1;
  for (std::size_t step = 1; low > first && starts[low] > time; step *= 2) {
    high = low;
    low -= std::min(low - first, step);
  }
  for (std::size_t step = 1; high < end && starts[high] <= time; step *= 2) {
    low = high;
    high = std::min(high + step, end);
  }
  if (high == low + 1) return low;
  const auto at = [&](std::size_t index) { return starts.begin() + static_cast<std::ptrdiff_t>(index); };
  const auto after = std::upper_bound(at(low), at(high), time);
  return after == at(low) ? low : static_cast<std::size_t>(after - starts.begin()) - 1;
}

JointState Interpolant::state(double time) const {
  return piece_count_ == 0 ? state(0, time) : state(piece_at(time), time);
}

JointState Interpolant::state(std::size_t piece, double time) const {
  const auto last = static_cast<std::size_t>(knots_.rows()) - 1;
  if (piece_count_ == 0 || time <= of_pieces(kStart).front()) return {positions().front(), velocities().front()};
  if (time >= times()[last]) return {positions()[last], velocities()[last]};
  const std::size_t before = knot_before(piece);
  return Quintic::state(knot(before), knot(before + 1), time);
}

double Interpolant::travel(Interval time) const {
  return piece_count_ == 0 ? 0.0 : travel(piece_at(time.lower), piece_at(time.upper), time);
}

double Interpolant::travel(std::size_t first, std::size_t last, Interval time) const {
  const double all = travelled(last, time.upper);
  if (!std::isfinite(all)) return kInfinity;
  const double way = all - travelled(first, time.lower);
  // Each piece between the two has rounded a sum that is no more than all of the way.
  const double rounding = static_cast<double>(last - first + 4) * std::numeric_limits<double>::epsilon() * all;
  return way == 0.0 ? 0.0 : std::max(0.0, way) + rounding;
}

/// Bound (rad) on the way from the start to a time during a piece.
double Interpolant::travelled(std::size_t piece, double time) const {
  const double duration = durations()[piece];
  const double left = std::clamp(of_pieces(kStart)[piece] + duration - time, 0.0, duration);
  return of_pieces(kTravelled)[piece] - left * of_pieces(kSpeed)[piece];
}

Interpolant::Bounds Interpolant::bounds(Interval time) const {
  return piece_count_ == 0 ? Bounds() : bounds(piece_at(time.lower), piece_at(time.upper), time);
}

Interpolant::Bounds Interpolant::bounds(std::size_t first, std::size_t last, Interval time) const {
  Bounds most;
  if (time.lower >= times().back()) return most;
  const std::span<const double> of_speed = speeds();
  const std::span<const double> of_acceleration = most_accelerations();
  for (std::size_t i = first; i <= last;) {
    const bool is_whole = i % kBlockSize == 0 && i + kBlockSize <= last + 1;
    const auto block = static_cast<Eigen::Index>(i / kBlockSize);
    most.speed = std::max(most.speed, is_whole ? blocks_(block, 0) : of_speed[i]);
    most.acceleration = std::max(most.acceleration, is_whole ? blocks_(block, 1) : of_acceleration[i]);
    i += is_whole ? kBlockSize : 1;
  }
  return most;
}

Interpolant::During Interpolant::during(Interval time) const {
  const double middle = 0.5 * (time.lower + time.upper);
  if (piece_count_ == 0) return {state(0, middle), 0.0, {}};
  const std::size_t first = piece_at(time.lower);
  const std::size_t in_the_middle = piece_at(middle);
  const std::size_t last = piece_at(time.upper);
  return {
      state(in_the_middle, middle),
      std::max(travel(first, in_the_middle, {time.lower, middle}), travel(in_the_middle, last, {middle, time.upper})),
      bounds(first, last, time)};
}

}  // namespace dualarm

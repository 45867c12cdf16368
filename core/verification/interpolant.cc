#include "core/verification/interpolant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/verification/pair.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBlockSize = 16;  // pieces

/// What is gathered over all pieces.
template <typename Number>
struct Gathered {
  Number lowest = Number() + kInfinity;
  Number highest = Number() - kInfinity;
  Number slowest = Number() + kInfinity;
  Number fastest = Number() - kInfinity;
  Number doubt = Number();  // 0 while all numbers are finite
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
void bound_position(const Columns& columns, std::size_t i, Number h, Gathered<Number>& all) {
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
  const Number lowest = lesser(lesser(lesser(q0, q1), lesser(second, third)), lesser(fourth, fifth));
  const Number highest = greater(greater(greater(q0, q1), greater(second, third)), greater(fourth, fifth));
  store(columns.lowest + i, lowest);
  store(columns.highest + i, highest);
  all.lowest = lesser(all.lowest, lowest);
  all.highest = greater(all.highest, highest);
  const Number sum = second + third + fourth + fifth;
  all.doubt = all.doubt + (sum - sum);
}

/// The same of velocity and acceleration. They are written out, because differences of the position's coefficients lose
/// digits over short times.
template <typename Number>
void bound_rates(const Columns& columns, std::size_t i, Number h, Gathered<Number>& all) {
  const Number per = 1.0 / h;
  const Number mean = (load<Number>(columns.position + i + 1) - load<Number>(columns.position + i)) * per;
  const Number v0 = load<Number>(columns.velocity + i);
  const Number v4 = load<Number>(columns.velocity + i + 1);
  const Number a0 = load<Number>(columns.acceleration + i);
  const Number a3 = load<Number>(columns.acceleration + i + 1);
  const Number v1 = v0 + 0.25 * h * a0;
  const Number v2 = 5.0 * mean - 2.0 * (v0 + v4) + 0.25 * h * (a3 - a0);
  const Number v3 = v4 - 0.25 * h * a3;
  const Number slowest = lesser(lesser(lesser(v0, v1), lesser(v3, v4)), v2);
  const Number fastest = greater(greater(greater(v0, v1), greater(v3, v4)), v2);
  const Number speed = greater(fastest, -slowest);
  const Number a1 = 20.0 * (mean - 0.6 * v0 - 0.4 * v4) * per + a3 - 2.0 * a0;
  const Number a2 = 20.0 * (0.4 * v0 + 0.6 * v4 - mean) * per + a0 - 2.0 * a3;
  const Number most_acceleration =
      greater(greater(magnitude(a0), magnitude(a1)), greater(magnitude(a2), magnitude(a3)));
  store(columns.slowest + i, slowest);
  store(columns.fastest + i, fastest);
  store(columns.speed + i, speed);
  store(columns.second + i, a1);
  store(columns.third + i, a2);
  store(columns.most_acceleration + i, most_acceleration);

  all.slowest = lesser(all.slowest, slowest);
  all.fastest = greater(all.fastest, fastest);
  const Number sum = (a1 + a2) + (v1 + v2 + v3);
  all.doubt = all.doubt + (sum - sum);
}

template <typename Number>
void bound_piece(const Columns& columns, std::size_t i, Gathered<Number>& all) {
  const Number time = load<Number>(columns.time + i);
  const Number h = load<Number>(columns.time + i + 1) - time;
  store(columns.start + i, time);
  store(columns.duration + i, h);
  bound_position(columns, i, h, all);
  bound_rates(columns, i, h, all);
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
  double* const time = knots_.col(kTime).data();
  double* const position = knots_.col(kPosition).data();
  double* const velocity = knots_.col(kVelocity).data();
  double* const acceleration = knots_.col(kAcceleration).data();
  std::size_t first = 0;
  const auto end_run = [&](std::size_t last) {
    if (last > first) runs_.push_back({first, piece_count_, last - first});
    piece_count_ += last - first;
    first = last + 1;
  };
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const Knot& knot = knots[k];
    time[k] = knot.time;
    position[k] = knot.position;
    velocity[k] = knot.velocity;
    acceleration[k] = knot.acceleration;
    if (k > 0 && share_a_time(time[k - 1], knot.time)) end_run(k - 1);
  }
  end_run(knots.size() - 1);
}

void Interpolant::bound_pieces() {
  Gathered<Pair> pairs;
  Gathered<double> all;
  const auto bound = [&](const Columns& columns, auto number, std::size_t i) {
    if constexpr (sizeof number == sizeof(Pair)) bound_piece(columns, i, pairs);
    if constexpr (sizeof number == sizeof(double)) bound_piece(columns, i, all);
  };
  for (const Run& run : runs_) {
    const auto of_knots = [&](KnotColumn column) { return knots_.col(column).data() + run.first_knot; };
    const auto of_pieces = [&](PieceColumn column) { return pieces_.col(column).data() + run.first_piece; };
    const Columns columns = {of_knots(kTime),         of_knots(kPosition),         of_knots(kVelocity),
                             of_knots(kAcceleration), of_pieces(kStart),           of_pieces(kDuration),
                             of_pieces(kSecond),      of_pieces(kThird),           of_pieces(kLowest),
                             of_pieces(kHighest),     of_pieces(kSlowest),         of_pieces(kFastest),
                             of_pieces(kSpeed),       of_pieces(kMostAcceleration)};
    for_pairs(run.piece_count, [&](auto number, std::size_t i) { bound(columns, number, i); });
  }
  position_range_ = {lesser(all.lowest, least_of(pairs.lowest)), greater(all.highest, most_of(pairs.highest))};
  velocity_range_ = {lesser(all.slowest, least_of(pairs.slowest)), greater(all.fastest, most_of(pairs.fastest))};
  if (!(all.doubt + pairs.doubt[0] + pairs.doubt[1] == 0.0)) overflow();
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

/// The last piece that begins by a time, or the first one. Most motions have pieces of nearly the same duration: they
/// tell where to look first, and from there in steps twice as long each time.
std::size_t Interpolant::piece_at(double time) const {
  const std::span<const double> starts = of_pieces(kStart);
  const double part = (time - starts.front()) / (times().back() - starts.front());
  const std::size_t last = piece_count_ - 1;
  // Written so that what is not a number leads to the first piece.
  const std::size_t guess = !(part > 0.0) ? 0
                            : part >= 1.0 ? last
                                          : static_cast<std::size_t>(part * static_cast<double>(piece_count_));
  std::size_t low = std::min(guess, last);
  std::size_t high = low + 1;
  for (std::size_t step = 1; low > 0 && starts[low] > time; step *= 2) {
    high = low;
    low -= std::min(low, step);
  }
  for (std::size_t step = 1; high <= last && starts[high] <= time; step *= 2) {
    low = high;
    high = std::min(high + step, last + 1);
  }
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

#include "core/coordination/least_value.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of a position to which two positions are one.
constexpr double kSamePosition = 1e-15;
/// Part of a gap beside the lowest point in which a guess is put to the test.
constexpr double kBeside = 1e-3;

double difference(double one, double other) {
  const double apart = std::abs(one - other);
  return std::isnan(apart) ? kInfinity : apart;
}

}  // namespace

LeastValueSearch::LeastValueSearch(const std::array<Looked, 3>& known) {
  constexpr std::size_t kUsual = 16;
  points_.reserve(kUsual);
  points_.assign(known.begin(), known.end());
  if (points_.front().position > points_.back().position) std::reverse(points_.begin(), points_.end());
}

std::size_t LeastValueSearch::lowest() const {
  const auto lower = [](const Looked& a, const Looked& b) { return a.value < b.value; };
  return static_cast<std::size_t>(std::min_element(points_.begin(), points_.end(), lower) - points_.begin());
}

double LeastValueSearch::slope(std::size_t left) const {
  return (points_[left + 1].value - points_[left].value) / (points_[left + 1].position - points_[left].position);
}

double LeastValueSearch::line(std::size_t left, double position) const {
  return points_[left].value + slope(left) * (position - points_[left].position);
}

LeastValueSearch::Guess LeastValueSearch::of_parabola(std::optional<double> position) const {
  const std::size_t middle = lowest();
  if (middle == 0 || !is_finite(middle - 1) || !is_finite(middle + 1)) return {};
  const Looked& at = points_[middle];
  const double bend =
      (slope(middle) - slope(middle - 1)) / (points_[middle + 1].position - points_[middle - 1].position);
  const double rise = slope(middle) - bend * (points_[middle + 1].position - at.position);
  if (!(bend > 0.0)) return {};
  const double way = position ? *position - at.position : -0.5 * rise / bend;
  return {at.position + way, at.value + way * (rise + way * bend)};
}

LeastValueSearch::Guess LeastValueSearch::of_gap(std::size_t left, std::optional<double> position) const {
  const std::size_t right = left + 1;
  const Interval gap = {points_[left].position, points_[right].position};
  const double middle = 0.5 * (gap.lower + gap.upper);
  const bool has_left = left > 0 && is_finite(left - 1) && is_finite(left);
  const bool has_right = is_finite(right) && is_finite(right + 1);
  if (!has_left && !has_right) return {middle, -kInfinity};
  if (!has_right) return {middle, line(left - 1, position.value_or(gap.upper))};
  if (!has_left) return {middle, line(right, position.value_or(gap.lower))};
  const double fall = slope(left - 1);
  const double rise = slope(right);
  if (position) return {*position, std::max(line(left - 1, *position), line(right, *position))};
  const double lower = std::min(points_[left].value, points_[right].value);
  if (fall >= rise) return {middle, lower - 0.25 * (fall - rise) * gap.length()};  // not convex
  const double meeting = gap.upper - (line(left - 1, gap.upper) - points_[right].value) / (fall - rise);
  if (!(gap.lower < meeting && meeting < gap.upper)) return {middle, lower};
  return {meeting, line(left - 1, meeting)};
}

LeastValueSearch::Guess LeastValueSearch::of_lines() const {
  const std::size_t middle = lowest();
  Guess best;
  if (middle > 0) best = of_gap(middle - 1, {});
  if (middle + 1 < points_.size()) {
    const Guess right = of_gap(middle, {});
    if (right.value < best.value) best = right;
  }
  return best;
}

LeastValueSearch::Guess LeastValueSearch::guess() const {
  const Guess parabola = trusts_parabola_ ? of_parabola({}) : Guess{};
  return std::isfinite(parabola.value) ? parabola : of_lines();
}

std::size_t LeastValueSearch::gap_of(double position) const {
  std::size_t left = 0;
  while (left + 2 < points_.size() && points_[left + 1].position < position) ++left;
  return left;
}

bool LeastValueSearch::is_closed(std::size_t left) const {
  const double size = std::max(std::abs(points_[left].position), std::abs(points_[left + 1].position));
  return points_[left + 1].position - points_[left].position <= 2.0 * kSamePosition * size;
}

/// Where a guess is put to the test; nothing where there is no room.
std::optional<double> LeastValueSearch::beside_lowest(bool is_below) const {
  const std::size_t middle = lowest();
  if (middle == (is_below ? 0 : points_.size() - 1) || is_closed(is_below ? middle - 1 : middle)) return std::nullopt;
  return std::lerp(points_[middle].position, points_[is_below ? middle - 1 : middle + 1].position, kBeside);
}

double LeastValueSearch::next() const {
  std::optional<double> beside;
  if (looks_beside_ > 0) beside = beside_lowest(looks_beside_ == 1);
  const double position = beside ? *beside : guess().position;
  const std::size_t left = gap_of(position);
  const Interval gap = {points_[left].position, points_[left + 1].position};
  const double same = kSamePosition * std::max(std::abs(gap.lower), std::abs(gap.upper));
  return position - gap.lower > same && gap.upper - position > same ? position : 0.5 * (gap.lower + gap.upper);
}

bool LeastValueSearch::add(Looked looked, double enough) {
  const std::size_t left = gap_of(looked.position);
  const double miss_of_parabola = difference(of_parabola(looked.position).value, looked.value);
  const double miss_of_lines = difference(of_gap(left, looked.position).value, looked.value);
  const double news = std::isinf(looked.value) ? 0.0 : trusts_parabola_ ? miss_of_parabola : miss_of_lines;
  trusts_parabola_ = miss_of_parabola <= miss_of_lines && std::isfinite(miss_of_parabola);
  points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(left) + 1, looked);
  if (is_closed(gap_of(guess().position))) return false;
  if (news > enough || least() - guess().value > enough) {
    looks_beside_ = 0;
    return true;
  }
  looks_beside_ = looks_beside_ == 0 ? 2 : looks_beside_ - 1;
  if (looks_beside_ == 2 && !beside_lowest(false)) looks_beside_ = 1;
  if (looks_beside_ == 1 && !beside_lowest(true)) looks_beside_ = 0;
  return looks_beside_ > 0;
}

}  // namespace dualarm

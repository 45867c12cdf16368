#include "core/passage/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Part of a slice by which a staircase stays inside its end: on the end itself rounding decides what is forbidden.
constexpr double kInset = 1e-3;
/// Width (rad) of a gap at the border through which nothing is taken to pass: arms without thickness touch the border
/// in a single point.
constexpr double kContact = 1e-7;
/// Steps of a staircase, and the part of the slice before by which a step has to get on.
constexpr int kMostSteps = 20;
constexpr double kLeastProgress = 1e-2;

}  // namespace

Obstacle::Obstacle(const ForbiddenPlane& plane, std::array<double, kArmCount> start, std::array<double, kArmCount> goal,
                   const Slice& seed, const Budget& budget)
    : plane_(&plane), start_{start[0], start[1]}, goal_{goal[0], goal[1]} {
  const Piece first = {seed, seed.forbidden.lower, false};
  pieces_.push_back(first);
  note_contacts(first);
  for (const double first_sign : {-1.0, 1.0}) {
    for (const double second_sign : {-1.0, 1.0}) walk(first, first_sign, second_sign, budget);
  }
}

Obstacle::Point Obstacle::point_on(const Slice& slice, double position) {
  return slice.pinned_arm == 0 ? Point{slice.position, position} : Point{position, slice.position};
}

/// The reference goes from the start along arm 1 to its goal, then along arm 2. It is taken to lie an infinitely small
/// step above and to the right of where it is, so that no line ever runs along it.
bool Obstacle::crosses_reference(const Slice& line, double from, double to) const {
  if (line.pinned_arm == 0) {
    const bool is_between = (line.position > start_.first) != (line.position > goal_.first);
    return is_between && (from > start_.second) != (to > start_.second);
  }
  const bool is_between = (line.position > start_.second) != (line.position > goal_.second);
  return is_between && (from > goal_.first) != (to > goal_.first);
}

bool Obstacle::parity_at(const Piece& piece, double position) const {
  return piece.parity != crosses_reference(piece.slice, piece.anchor, position);
}

void Obstacle::note_contacts(const Piece& piece) {
  const Interval range = plane_->range(1 - piece.slice.pinned_arm);
  for (const bool runs_up : {false, true}) {
    const double end = runs_up ? piece.slice.forbidden.upper : piece.slice.forbidden.lower;
    if (runs_up ? end < range.upper - kContact : end > range.lower + kContact) continue;
    const bool outwards = crosses_reference(piece.slice, end, runs_up ? kInfinity : -kInfinity);
    closed_[parity_at(piece, end) != outwards ? 1 : 0] = true;
  }
}

/// A staircase of slices, in turn of either arm, towards one corner of the plane.
void Obstacle::walk(Piece from, double first_sign, double second_sign, const Budget& budget) {
  for (int i = 0; i < kMostSteps && !budget.exhausted(); ++i) {
    const Interval& stretch = from.slice.forbidden;
    const int other = 1 - from.slice.pinned_arm;
    const double sign = other == 0 ? first_sign : second_sign;
    const double inset = kInset * stretch.length();
    const double position = sign > 0.0 ? stretch.upper - inset : stretch.lower + inset;
    const auto next = plane_->slice_through(other, position, from.slice.position);
    if (!next) return;
    const Piece piece = {*next, from.slice.position, parity_at(from, position)};
    pieces_.push_back(piece);
    note_contacts(piece);
    const double ahead = (other == 0 ? second_sign : first_sign) > 0.0 ? next->forbidden.upper - from.slice.position
                                                                       : from.slice.position - next->forbidden.lower;
    if (ahead <= kLeastProgress * next->forbidden.length() || ahead <= kContact) return;
    from = piece;
  }
}

/// The slice as a piece, if it crosses one that is known.
std::optional<Obstacle::Piece> Obstacle::joined(const Slice& slice) const {
  for (const Piece& piece : pieces_) {
    if (piece.slice == slice) return piece;
    if (cross(piece.slice, slice)) return Piece{slice, piece.slice.position, parity_at(piece, slice.position)};
  }
  return std::nullopt;
}

/// The slice as a piece, if a step to either side of its middle and staircases from there meet what is known.
std::optional<Obstacle::Piece> Obstacle::walked(const Slice& slice) {
  const int other = 1 - slice.pinned_arm;
  const double middle = 0.5 * (slice.forbidden.lower + slice.forbidden.upper);
  const auto through = plane_->slice_through(other, middle, slice.position);
  if (!through) return std::nullopt;
  for (const double share : {0.5, 0.1, 0.9}) {
    const double position = through->forbidden.lower + share * through->forbidden.length();
    const auto beside = plane_->slice_through(slice.pinned_arm, position, middle);
    if (!beside) continue;
    const auto known = joined(*beside);
    if (!known) continue;
    const Piece crossing = {*through, position, parity_at(*known, middle)};
    pieces_.push_back(*known);
    pieces_.push_back(crossing);
    return Piece{slice, middle, parity_at(crossing, slice.position)};
  }
  return std::nullopt;
}

std::optional<int> Obstacle::side_of(const Slice& slice, bool runs_up) {
  std::optional<Piece> piece = joined(slice);
  if (!piece) {
    const double middle = 0.5 * (slice.forbidden.lower + slice.forbidden.upper);
    const auto through = plane_->slice_through(1 - slice.pinned_arm, middle, slice.position);
    const auto known = through ? joined(*through) : std::nullopt;
    if (known) {
      pieces_.push_back(*known);
      piece = Piece{slice, middle, parity_at(*known, slice.position)};
    } else {
      piece = walked(slice);
    }
  }
  if (!piece) return std::nullopt;
  const double end = runs_up ? slice.forbidden.upper : slice.forbidden.lower;
  const bool outwards = crosses_reference(slice, end, runs_up ? kInfinity : -kInfinity);
  return parity_at(*piece, end) != outwards ? 1 : 0;
}

std::vector<Slice> Obstacle::slices() const {
  std::vector<Slice> slices;
  for (const Piece& piece : pieces_) slices.push_back(piece.slice);
  return slices;
}

Interval Obstacle::extent(int arm) const {
  Interval extent = {kInfinity, -kInfinity};
  for (const Piece& piece : pieces_) {
    const Slice& slice = piece.slice;
    const Interval of_slice = slice.pinned_arm == arm ? Interval{slice.position, slice.position} : slice.forbidden;
    extent = {std::min(extent.lower, of_slice.lower), std::max(extent.upper, of_slice.upper)};
  }
  return extent;
}

}  // namespace dualarm

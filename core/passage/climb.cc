#include "core/passage/climb.h"

#include <algorithm>
#include <limits>

namespace dualarm {
namespace {

/// Part of a bracket beside an end in which a corner is taken to lie there; by how much farther than the tangents say
/// the next position then is from it, so that the corner comes to lie between.
constexpr double kBesideEnd = 0.01;
constexpr double kFarther = 8.0;

double meeting_of(const Rated& left, const Rated& right) {
  const double width = right.position - left.position;
  return left.position + (right.value - left.value - right.slope * width) / (left.slope - right.slope);
}

}  // namespace

double Climb::promised() const {
  const double meet = meeting_of(*left, *right);
  if (!bracket.contains(meet)) return std::numeric_limits<double>::infinity();
  return left->value + left->slope * (meet - left->position) - std::max(left->value, right->value);
}

double Climb::next(double step, bool at_tangents, double same) const {
  const double middle = 0.5 * (bracket.lower + bracket.upper);
  if (!left) return std::max(middle, bracket.upper - step);
  if (!right) return std::min(middle, bracket.lower + step);
  const double width = bracket.length();
  const double aim =
      at_tangents ? meeting_of(*left, *right) : bracket.lower + width * left->slope / (left->slope - right->slope);
  if (!bracket.contains(aim)) return middle;
  const auto inset = [&](double gap) { return std::min(0.5 * width, std::max(kFarther * gap, same)); };
  if (aim - bracket.lower < kBesideEnd * width) return bracket.lower + inset(aim - bracket.lower);
  if (bracket.upper - aim < kBesideEnd * width) return bracket.upper - inset(bracket.upper - aim);
  return aim;
}

}  // namespace dualarm

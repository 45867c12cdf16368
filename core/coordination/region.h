#pragma once

#include <optional>
#include <vector>

#include "core/model/budget.h"
#include "core/model/problem.h"

namespace dualarm {

/// A closed polygon in the plane of the joint positions (theta1, theta2), rad.
struct Contour {
  std::vector<double> theta1;
  std::vector<double> theta2;
};

/// Contours of the set of joint positions that the problem's region model forbids, at the demanded clearance, clipped
/// to the rectangle of the joint ranges. Filled by the even-odd rule they are the set. Vertices lie on the set's
/// boundary to 1e-9 rad; features narrower than a cell of the `resolution` x `resolution` grid may be missed.
/// resolution: points a side, 2..2000. Nothing where the budget, polled at every column and vertex, ran out: half a set
/// would look like a smaller one. Theory, section 2; figure 2 of the paper.
std::optional<std::vector<Contour>> forbidden_region(const Problem& problem, int resolution, const Budget& budget);

}  // namespace dualarm

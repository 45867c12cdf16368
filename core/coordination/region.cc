#include "core/coordination/region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/coordination/forbidden_set.h"

namespace dualarm {
namespace {

/// Halvings after which a vertex lies on the boundary to 1e-9 rad and better.
constexpr int kHalvings = 40;

struct Point {
  double theta1;
  double theta2;
};

/// An edge of the grid by its lower left node; horizontal edges run along theta1.
using Edge = std::tuple<int, int, bool>;

/// Marching squares over the joint rectangle, with a ring of free nodes around it so that contours close on its border.
class Marching {
 public:
  Marching(const Problem& problem, int resolution, const Budget& budget)
      : forbidden_(problem, problem.options.clearance),
        range1_(problem.arms[0].joint_range),
        range2_(problem.arms[1].joint_range),
        count_(resolution),
        inside_(static_cast<std::size_t>(resolution) * resolution),
        budget_(budget) {}

  std::optional<std::vector<Contour>> run() {
    if (!mark_nodes()) return std::nullopt;
    for (int i = -1; i < count_; ++i) {
      for (int j = -1; j < count_; ++j) connect_cell(i, j);
    }
    std::vector<Contour> contours;
    while (!next_.empty()) {
      std::optional<Contour> contour = pull_contour();
      if (!contour) return std::nullopt;
      contours.push_back(*std::move(contour));
    }
    return contours;
  }

 private:
  /// False if the budget ran out.
  bool mark_nodes() {
    for (int i = 0; i < count_; ++i) {
      if (budget_.exhausted()) return false;
      const IntervalSet slice = forbidden_.slice(node(i, 0).theta1, range2_);
      for (int j = 0; j < count_; ++j) inside_[index(i, j)] = slice.contains(node(i, j).theta2);
    }
    return true;
  }

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i) * count_ + j; }

  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < count_ && j < count_ && inside_[index(i, j)]; }

  Point node(int i, int j) const {
    const auto coordinate = [this](const Interval& range, int k) {
      return range.lower + range.length() * std::clamp(k, 0, count_ - 1) / (count_ - 1);
    };
    return {coordinate(range1_, i), coordinate(range2_, j)};
  }

  /// Contour pieces of a cell lead from an edge on which a counterclockwise walk leaves the set to the next on which it
  /// enters it again: the set stays on their left.
  void connect_cell(int i, int j) {
    const std::array<bool, 4> corners = {inside(i, j), inside(i + 1, j), inside(i + 1, j + 1), inside(i, j + 1)};
    const std::array<Edge, 4> edges = {Edge{i, j, true}, Edge{i + 1, j, false}, Edge{i, j + 1, true},
                                       Edge{i, j, false}};
    for (int k = 0; k < 4; ++k) {
      if (!corners[k] || corners[(k + 1) % 4]) continue;
      int entry = (k + 1) % 4;
      while (corners[entry] || !corners[(entry + 1) % 4]) entry = (entry + 1) % 4;
      next_[edges[k]] = edges[entry];
    }
  }

  std::optional<Contour> pull_contour() {
    Contour contour;
    for (auto step = next_.begin(); step != next_.end();) {
      if (budget_.exhausted()) return std::nullopt;
      const Point point = crossing_of(step->first);
      contour.theta1.push_back(point.theta1);
      contour.theta2.push_back(point.theta2);
      const Edge following = step->second;
      next_.erase(step);
      step = next_.find(following);
    }
    return contour;
  }

  /// Where the boundary crosses an edge of the grid.
  Point crossing_of(const Edge& edge) const {
    const auto [i, j, horizontal] = edge;
    const int i2 = horizontal ? i + 1 : i;
    const int j2 = horizontal ? j : j + 1;
    Point in = inside(i, j) ? node(i, j) : node(i2, j2);
    Point out = inside(i, j) ? node(i2, j2) : node(i, j);
    for (int k = 0; k < kHalvings && (in.theta1 != out.theta1 || in.theta2 != out.theta2); ++k) {
      const Point middle = {0.5 * (in.theta1 + out.theta1), 0.5 * (in.theta2 + out.theta2)};
      (forbidden_.contains(middle.theta1, middle.theta2) ? in : out) = middle;
    }
    return in;
  }

  ForbiddenSet forbidden_;
  Interval range1_;
  Interval range2_;
  int count_;
  std::vector<char> inside_;
  const Budget& budget_;
  std::map<Edge, Edge> next_;
};

}  // namespace

std::optional<std::vector<Contour>> forbidden_region(const Problem& problem, int resolution, const Budget& budget) {
  return Marching(problem, resolution, budget).run();
}

}  // namespace dualarm

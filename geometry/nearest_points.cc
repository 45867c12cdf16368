#include "geometry/nearest_points.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/support.h"

namespace dualarm {
namespace {

// Round bodies gain about a digit every few steps; polytopes of this house need some 10.
constexpr int kMostSteps = 200;

// Weights below this are rounding: the point is superfluous.
constexpr double kLeastWeight = 1e-14;

// A corner of the difference of two shapes.
struct Corner {
  Eigen::Vector3d on_first;
  Eigen::Vector3d on_second;
  double weight = 0.0;

  Eigen::Vector3d difference() const { return on_first - on_second; }
};

/// Corners that are affinely independent, so at most four, and one to come.
using Corral = std::vector<Corner>;
using Edges = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 4>;
using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>;

Eigen::Vector3d point(const Corral& corral) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Corner& corner : corral) sum += corner.weight * corner.difference();
  return sum;
}

/// Weights, of sum 1, of the point nearest to the origin in the affine hull.
Weights affine_weights(const Corral& corral) {
  const Eigen::Vector3d foot = corral.back().difference();
  const auto count = static_cast<Eigen::Index>(corral.size());
  Weights weights = Weights::Ones(count);
  if (count == 1) return weights;
  Edges edges(3, count - 1);
  for (Eigen::Index i = 0; i + 1 < count; ++i) edges.col(i) = corral[static_cast<std::size_t>(i)].difference() - foot;
  weights.head(count - 1) = edges.colPivHouseholderQr().solve(-foot);
  weights(count - 1) = 1.0 - weights.head(count - 1).sum();
  return weights;
}

/// Moves to the point nearest to the origin in the convex hull of the corral, and drops the corners it does not need.
void settle(Corral& corral) {
  while (true) {
    const Weights wanted = affine_weights(corral);
    double share = 1.0;
    for (std::size_t i = 0; i < corral.size(); ++i) {
      const double weight = corral[i].weight;
      const double change = weight - wanted(static_cast<Eigen::Index>(i));
      if (wanted(static_cast<Eigen::Index>(i)) < kLeastWeight && change > 0.0) share = std::min(share, weight / change);
    }
    for (std::size_t i = 0; i < corral.size(); ++i) {
      corral[i].weight += share * (wanted(static_cast<Eigen::Index>(i)) - corral[i].weight);
    }
    const std::size_t before = corral.size();
    std::erase_if(corral, [](const Corner& corner) { return corner.weight < kLeastWeight; });
    if (share == 1.0 || corral.size() == before) return;
  }
}

}  // namespace

double separation(const Shape& first, const Shape& second, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d normal = direction.stableNormalized();
  return normal.dot(farthest_point(first, -normal) - farthest_point(second, normal));
}

NearestPoints nearest_points(const Shape& first, const Shape& second, const Eigen::Vector3d& guess, double size) {
  const double gap = kNearestPointsGap * size;
  const auto corner_towards = [&](const Eigen::Vector3d& direction) -> Corner {
    return {farthest_point(first, -direction), farthest_point(second, direction), 0.0};
  };
  Corral corral = {corner_towards(guess)};
  corral[0].weight = 1.0;
  double lower_bound = 0.0;
  double upper_bound = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Vector3d nearest = point(corral);
    const double length = nearest.norm();
    if (length >= upper_bound || length <= gap) break;
    upper_bound = length;
    Corner corner = corner_towards(nearest);
    lower_bound = std::max(lower_bound, nearest.dot(corner.difference()) / length);
    if (upper_bound - lower_bound <= gap) break;
    corral.push_back(corner);
    settle(corral);
  }
  NearestPoints result;
  for (const Corner& corner : corral) {
    result.on_first += corner.weight * corner.on_first;
    result.on_second += corner.weight * corner.on_second;
  }
  result.lower_bound = std::min(lower_bound, result.upper_bound());
  return result;
}

}  // namespace dualarm

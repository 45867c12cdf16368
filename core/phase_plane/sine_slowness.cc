#include "core/phase_plane/sine_slowness.h"

#include <Eigen/Core>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace dualarm {
namespace {

/// rad. Up to here the first terms left out below, of quarters of the way, are less than 1e-16 of the sine.
constexpr double kMostChange = 3.2;

/// Part of a time by which a rule and the one within it may differ. How much they do bounds the error no better: 0.4 of
/// it has been seen.
constexpr double kAgreement = 1e-13;

/// The nodes of a Gauss-Kronrod rule over [-1, 1] with the weights of both rules, 0 where the inner one has no node. A
/// last one without weight makes their number even.
template <int kNodes>
struct Nodes {
  using Column = Eigen::Array<double, kNodes + 1, 1>;

  Column place = Column::Zero();
  Column weight = Column::Zero();
  Column inner_weight = Column::Zero();

  Nodes() {
    using Outer = boost::math::quadrature::gauss_kronrod<double, kNodes>;
    constexpr unsigned kInner = (kNodes - 1) / 2;
    const auto& inner = boost::math::quadrature::gauss<double, kInner>::weights();
    constexpr std::size_t kFirstInner = kInner % 2 == 0 ? 1 : 0;  // an even rule has no node in the middle
    for (std::size_t k = 0; k <= kInner; ++k) {
      for (const int side : {-1, 1}) {
        const Eigen::Index at = static_cast<Eigen::Index>(kInner) + side * static_cast<int>(k);
        place[at] = side * Outer::abscissa()[k];
        weight[at] = Outer::weights()[k];
        inner_weight[at] = k % 2 == kFirstInner ? inner[k / 2] : 0.0;
      }
    }
  }
};

/// Sine and cosine of a column by their series.
template <typename Column>
struct SineAndCosine {
  Column sine;
  Column cosine;

  explicit SineAndCosine(const Column& x) {
    // Each factor is that of a term to the one before: 1 / (n (n - 1)).
    const Column y = x * x;
    sine = 1.0 - y * (1.0 / 210.0);
    for (const double factor : {1.0 / 156.0, 1.0 / 110.0, 1.0 / 72.0, 1.0 / 42.0, 1.0 / 20.0, 1.0 / 6.0}) {
      sine = 1.0 - factor * y * sine;
    }
    sine *= x;
    cosine = 1.0 - y * (1.0 / 240.0);
    for (const double factor : {1.0 / 182.0, 1.0 / 132.0, 1.0 / 90.0, 1.0 / 56.0, 1.0 / 30.0, 1.0 / 12.0, 1.0 / 2.0}) {
      cosine = 1.0 - factor * y * cosine;
    }
  }
};

}  // namespace

template <int kNodes>
std::optional<double> SineSlowness::by_rule(double first, double last) const {
  static const Nodes<kNodes> nodes;
  using Column = typename Nodes<kNodes>::Column;
  const double half = 0.5 * (last - first);
  const Column root = first + half * (1.0 + nodes.place);
  const Column change = away_ * (root * root - behind_).max(0.0);
  const SineAndCosine<Column> of_quarter(0.25 * change);
  const Column half_sine = 2.0 * of_quarter.sine * of_quarter.cosine;
  const Column half_cosine = 1.0 - 2.0 * of_quarter.sine * of_quarter.sine;
  const Column work = work_.constant * change - 2.0 * half_sine * (work_.sine * half_cosine + work_.cosine * half_sine);
  const Column slowness = 2.0 * root / (anchor_square_ + 2.0 * work).max(0.0).sqrt();
  const double time = (slowness * nodes.weight).sum();
  const double inner = (slowness * nodes.inner_weight).sum();
  // What is not finite is not accepted either.
  return std::abs(time - inner) <= kAgreement * time ? std::optional(half * time) : std::nullopt;
}

std::optional<double> SineSlowness::time(double first, double last) const {
  if (!(last * last - behind_ <= kMostChange)) return std::nullopt;
  if (const auto time = by_rule<15>(first, last)) return time;
  if (const auto time = by_rule<21>(first, last)) return time;
  return by_rule<31>(first, last);
}

}  // namespace dualarm

#include "core/phase_plane/sine_slowness.h"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "core/model/wide_registers.h"

namespace dualarm {
namespace {

/// rad. Up to here the first terms left out below, of quarters of the way, are less than 1e-16 of the sine.
constexpr double kMostChange = 3.2;

/// Part of a time by which a rule and the one within it may differ. How much they do bounds the error no better: 0.4 of
/// it has been seen.
constexpr double kAgreement = 1e-13;

/// Four nodes that are worked out at once.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

/// The nodes of a Gauss-Kronrod rule over [-1, 1] with the weights of both rules, 0 where the inner one has no node.
/// Last ones without weight make their number a multiple of four.
template <int kNodes>
struct Nodes {
  static constexpr std::size_t kFours = kNodes / 4 + 1;

  std::array<Four, kFours> place = {};
  std::array<Four, kFours> weight = {};
  std::array<Four, kFours> inner_weight = {};

  Nodes() {
    using Outer = boost::math::quadrature::gauss_kronrod<double, kNodes>;
    constexpr int kInner = (kNodes - 1) / 2;
    const auto& inner = boost::math::quadrature::gauss<double, static_cast<unsigned>(kInner)>::weights();
    constexpr std::size_t kFirstInner = kInner % 2 == 0 ? 1 : 0;  // an even rule has no node in the middle
    for (int k = 0; k <= kInner; ++k) {
      for (const int side : {-1, 1}) {
        const auto at = static_cast<std::size_t>(kInner + side * k);
        const auto node = static_cast<std::size_t>(k);
        place[at / 4][at % 4] = side * Outer::abscissa()[node];
        weight[at / 4][at % 4] = Outer::weights()[node];
        inner_weight[at / 4][at % 4] = node % 2 == kFirstInner ? inner[node / 2] : 0.0;
      }
    }
  }
};

/// Sine and cosine of four angles by their series.
struct SineAndCosine {
  Four sine;
  Four cosine;

  [[gnu::always_inline]] explicit SineAndCosine(const Four& x) {
    // Each factor is that of a term to the one before: 1 / (n (n - 1)).
    const Four y = x * x;
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

[[gnu::always_inline]] inline void set_positive(Four& numbers) { numbers = numbers > Four() ? numbers : Four(); }

[[gnu::always_inline]] inline void take_roots(Four& numbers) {
  for (int i = 0; i < 4; ++i) numbers[i] = std::sqrt(numbers[i]);
}

double sum_of(const Four& numbers) { return (numbers[0] + numbers[1]) + (numbers[2] + numbers[3]); }

}  // namespace

template <int kNodes>
std::optional<double> SineSlowness::by_rule(double first, double last) const {
  static const Nodes<kNodes> nodes;
  const double half = 0.5 * (last - first);
  Four time = {};
  Four inner = {};
  with_wide_registers([&] {
    Four time_here = {};
    Four inner_here = {};
    for (std::size_t i = 0; i < Nodes<kNodes>::kFours; ++i) {
      const Four root = first + half * (1.0 + nodes.place[i]);
      Four way = root * root - behind_;
      set_positive(way);
      const Four change = away_ * way;
      const SineAndCosine of_quarter(0.25 * change);
      const Four half_sine = 2.0 * of_quarter.sine * of_quarter.cosine;
      const Four half_cosine = 1.0 - 2.0 * of_quarter.sine * of_quarter.sine;
      const Four work =
          work_.constant * change - 2.0 * half_sine * (work_.sine * half_cosine + work_.cosine * half_sine);
      Four speed = anchor_square_ + 2.0 * work;
      set_positive(speed);
      take_roots(speed);
      const Four slowness = 2.0 * root / speed;
      time_here += slowness * nodes.weight[i];
      inner_here += slowness * nodes.inner_weight[i];
    }
    time = time_here;
    inner = inner_here;
  });
  const double all = sum_of(time);
  // What is not finite is not accepted either.
  return std::abs(all - sum_of(inner)) <= kAgreement * all ? std::optional(half * all) : std::nullopt;
}

std::optional<double> SineSlowness::time(double first, double last) const {
  if (!(last * last - behind_ <= kMostChange)) return std::nullopt;
  if (const auto time = by_rule<15>(first, last)) return time;
  if (const auto time = by_rule<21>(first, last)) return time;
  return by_rule<31>(first, last);
}

}  // namespace dualarm

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

#include "core/model/wide_registers.h"

namespace dualarm {

// Formulas that are evaluated for many pieces of a motion are templates over their number, which is a double or Lanes:
// four neighbours at once, in one register or two. Each of the four goes through the same roundings as a double does.

// Whatever passes Lanes by value is always inlined, so that it does not matter how they would be passed.
#pragma GCC diagnostic ignored "-Wpsabi"

inline constexpr std::size_t kLaneCount = 4;

/// Four numbers that are computed with at once.
using Lanes [[gnu::vector_size(kLaneCount * sizeof(double))]] = double;

/// One number from memory, or four neighbours.
template <typename Number>
[[gnu::always_inline]] inline Number load(const double* from) {
  Number number;
  std::memcpy(&number, from, sizeof number);
  return number;
}

template <typename Number>
[[gnu::always_inline]] inline void store(double* to, const Number& number) {
  std::memcpy(to, &number, sizeof number);
}

// What is not a number may be the lesser, the greater or neither.
template <typename Number>
[[gnu::always_inline]] inline Number lesser(const Number& left, const Number& right) {
  return left < right ? left : right;
}

template <typename Number>
[[gnu::always_inline]] inline Number greater(const Number& left, const Number& right) {
  return left > right ? left : right;
}

template <typename Number>
[[gnu::always_inline]] inline Number magnitude(const Number& number) {
  return greater<Number>(number, -number);
}

/// What is not a number, made infinite.
template <typename Number>
[[gnu::always_inline]] inline Number or_infinite(const Number& number) {
  return number == number ? number : Number() + std::numeric_limits<double>::infinity();
}

inline double least_of(const Lanes& lanes) { return lesser(lesser(lanes[0], lanes[1]), lesser(lanes[2], lanes[3])); }
inline double most_of(const Lanes& lanes) { return greater(greater(lanes[0], lanes[1]), greater(lanes[2], lanes[3])); }
inline double sum_of(const Lanes& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

[[gnu::always_inline]] inline Lanes widened(double number) { return Lanes() + number; }
[[gnu::always_inline]] inline const Lanes& widened(const Lanes& lanes) { return lanes; }

/// Calls visit<Number>(i) for all numbers below a count: for four of them from i on, or for each where they are fewer.
/// The last four may hold some of those before once more: to visit a number again has to do nothing new.
template <typename Visit>
[[gnu::always_inline]] inline void visit_lanes(std::size_t count, const Visit& visit) {
  if (count < kLaneCount) {
    for (std::size_t i = 0; i < count; ++i) visit.template operator()<double>(i);
    return;
  }
  for (std::size_t i = 0; i < count; i += kLaneCount) visit.template operator()<Lanes>(std::min(i, count - kLaneCount));
}

/// The same in the widest registers. `visit` has to be always inlined.
template <typename Visit>
void for_lanes(std::size_t count, const Visit& visit) {
  with_wide_registers([&] { visit_lanes(count, visit); });
}

/// The same with visit<Number>(i, all): what is gathered stays in registers on the way.
template <typename Gathered, typename Visit>
void gather_lanes(std::size_t count, Gathered& all, const Visit& visit) {
  with_wide_registers([&] {
    Gathered so_far = all;
    visit_lanes(
        count, [&]<typename Number>(std::size_t i)
                   __attribute__((always_inline)) { visit.template operator()<Number>(i, so_far); });
    all = so_far;
  });
}

}  // namespace dualarm

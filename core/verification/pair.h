#pragma once

#include <cstddef>
#include <cstring>
#include <limits>

namespace dualarm {

// Formulas that are evaluated for many pieces of a motion are templates over their number, which is a double or a Pair:
// two neighbours at once, in one register. Each half of a Pair goes through the same roundings as a double does.

/// Two numbers that are computed with at once.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

/// One number from memory, or two neighbours.
template <typename Number>
Number load(const double* from) {
  Number number;
  std::memcpy(&number, from, sizeof number);
  return number;
}

template <typename Number>
void store(double* to, Number number) {
  std::memcpy(to, &number, sizeof number);
}

// What is not a number may be the lesser, the greater or neither.
template <typename Number>
Number lesser(Number left, Number right) {
  return left < right ? left : right;
}

template <typename Number>
Number greater(Number left, Number right) {
  return left > right ? left : right;
}

template <typename Number>
Number magnitude(Number number) {
  return greater(number, -number);
}

/// What is not a number, made infinite.
template <typename Number>
Number or_infinite(Number number) {
  return number == number ? number : Number() + std::numeric_limits<double>::infinity();
}

inline double least_of(Pair pair) { return lesser(pair[0], pair[1]); }
inline double most_of(Pair pair) { return greater(pair[0], pair[1]); }

/// Calls visit(Pair(), i) for every other i below a count, and visit(double(), i) for a last one that has no neighbour.
template <typename Visit>
void for_pairs(std::size_t count, Visit visit) {
  std::size_t i = 0;
  for (; i + 1 < count; i += 2) visit(Pair(), i);
  if (i < count) visit(double(), i);
}

}  // namespace dualarm

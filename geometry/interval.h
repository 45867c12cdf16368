#pragma once

namespace dualarm {

/// A closed interval of real numbers [lower, upper]. Empty when lower > upper. Ends may be infinite where the user of
/// the interval says so.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;

  bool empty() const { return lower > upper; }
  double length() const { return upper - lower; }
  bool contains(double value) const { return lower <= value && value <= upper; }
  bool operator==(const Interval&) const = default;
};

}  // namespace dualarm

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dualarm {

/// What is wrong with one field of a request, and what would be right.
struct FieldViolation {
  std::string field;        ///< path as "robot.arms[1].link.length_m"
  std::string description;  ///< a phrase with the offending value and the remedy
};

/// Everything that is wrong with a request. Keeps the first kMostKept and counts the rest, so that a request of many
/// megabytes cannot make an answer of many megabytes.
class Violations {
 public:
  static constexpr std::size_t kMostKept = 200;

  void add(FieldViolation violation);

  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  const std::vector<FieldViolation>& kept() const { return kept_; }

 private:
  std::vector<FieldViolation> kept_;
  std::size_t count_ = 0;
};

}  // namespace dualarm

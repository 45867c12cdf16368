#pragma once

#include <string>
#include <string_view>

#include "server/request/ranges.h"
#include "server/request/request_limits.h"
#include "server/request/violations.h"

namespace dualarm {

/// A place in a request, and the list on which whatever is wrong there is noted. Readers take a message with its Field
/// and return what the message says; they go on after a violation, so that one answer names every one of them.
///
/// A field knows its parent and its own name; the path is put together only where there is something to complain of.
class Field {
 public:
  /// `name` is empty for the whole request. Names, `violations` and `limits` must outlive this field, and this field
  /// its children.
  Field(std::string_view name, Violations& violations, const RequestLimits& limits = kDefaultLimits)
      : Field(nullptr, name, kNoIndex, violations, limits) {}

  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  Field child(std::string_view name) const;
  Field child(std::string_view name, int index) const;

  /// Notes a violation of this field, or of the number or string `name` in it.
  void complain(std::string description) const;
  void complain(std::string_view name, std::string description) const;

  /// Notes that the message `name`, which this field must have, is not there.
  void complain_missing(std::string_view name, std::string_view remedy) const;

  /// The value, which must be in the range (NaN never is).
  double number(std::string_view name, double value, const Range& range) const;

  /// As "robot.arms[1].link".
  std::string path() const;

  /// Of the whole request.
  const RequestLimits& limits() const { return limits_; }

 private:
  static constexpr int kNoIndex = -1;

  Field(const Field* parent, std::string_view name, int index, Violations& violations, const RequestLimits& limits)
      : parent_(parent), name_(name), index_(index), violations_(violations), limits_(limits) {}

  const Field* parent_;  // null for the whole request
  std::string_view name_;
  int index_;
  Violations& violations_;
  const RequestLimits& limits_;
};

/// A string of a request as it may be shown in logs and answers: quoted, at most 64 characters, nothing but printable
/// ASCII.
std::string quoted(std::string_view text);

}  // namespace dualarm

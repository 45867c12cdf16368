#pragma once

#include <string>
#include <string_view>

#include "server/request/ranges.h"
#include "server/request/request_limits.h"
#include "server/request/violations.h"

namespace dualarm {

/// A place in a request, and the list on which whatever is wrong there is noted. Readers take a message with its Field
/// and return what the message says; they go on after a violation, so that one answer names every one of them.
class Field {
 public:
  /// `path` is empty for the whole request. `violations` and `limits` must outlive this field and its children.
  Field(std::string path, Violations& violations, const RequestLimits& limits = kDefaultLimits)
      : path_(std::move(path)), violations_(&violations), limits_(&limits) {}

  Field child(std::string_view name) const;
  Field child(std::string_view name, int index) const;

  /// Notes a violation of this field, or of the number or string `name` in it.
  void complain(std::string description) const;
  void complain(std::string_view name, std::string description) const;

  /// Notes that the message `name`, which this field must have, is not there.
  void complain_missing(std::string_view name, std::string_view remedy) const;

  /// The value, which must be in the range (NaN never is).
  double number(std::string_view name, double value, const Range& range) const;

  const std::string& path() const { return path_; }

  /// Of the whole request.
  const RequestLimits& limits() const { return *limits_; }

 private:
  std::string path_to(std::string_view name) const;

  std::string path_;
  Violations* violations_;
  const RequestLimits* limits_;
};

/// A string of a request as it may be shown in logs and answers: quoted, at most 64 characters, nothing but printable
/// ASCII.
std::string quoted(std::string_view text);

}  // namespace dualarm

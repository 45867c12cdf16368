#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "server/request/requests.h"
#include "tests/server/paper_request.h"

namespace dualarm {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A way to spoil a sound request, and what the only violation must then say.
template <typename Message>
struct ViolationCase {
  std::string name;
  std::function<void(Message&)> spoil;
  std::string field;
  std::string text;
};

using PlanCase = ViolationCase<wire::PlanMotionRequest>;
using VerifyCase = ViolationCase<wire::VerifyMotionRequest>;

template <typename Message>
std::vector<FieldViolation> violations_of(const Message& request) {
  const auto parsed = parse(request);
  const auto* violations = std::get_if<Violations>(&parsed);
  return violations == nullptr ? std::vector<FieldViolation>{} : violations->kept();
}

template <typename Message>
void expect_violation(Message request, const ViolationCase<Message>& expected) {
  SCOPED_TRACE(expected.name);
  expected.spoil(request);
  const std::vector<FieldViolation> found = violations_of(request);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].field, expected.field);
  EXPECT_THAT(found[0].description, ::testing::HasSubstr(expected.text));
}

}  // namespace dualarm

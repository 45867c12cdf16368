// What every test of damaged plans asks of the verifier.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/verification/verify.h"
#include "tests/core/verification/violation_kinds.h"

namespace dualarm {

/// The verification of a plan that has to hold.
inline Verification expect_to_hold(const Problem& problem, const Trajectory& trajectory) {
  Verification verification = verify(problem, trajectory, Budget());
  for (const Violation& violation : verification.violations) ADD_FAILURE() << violation.explanation;
  EXPECT_TRUE(verification.holds());
  return verification;
}

/// A damaged plan is refused, with the claim that is broken among those named, and each in words.
inline void expect_named(const Problem& problem, const Trajectory& trajectory, ViolationKind kind) {
  const Verification verification = verify(problem, trajectory, Budget());
  EXPECT_FALSE(verification.holds());
  EXPECT_THAT(kinds(verification), testing::Contains(kind));
  for (const Violation& violation : verification.violations) EXPECT_FALSE(violation.explanation.empty());
}

}  // namespace dualarm

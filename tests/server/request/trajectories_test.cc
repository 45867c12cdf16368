#include "server/request/trajectories.h"

#include <gtest/gtest.h>

#include "tests/server/request/violation_cases.h"

namespace dualarm {
namespace {

wire::Knots& knots(wire::VerifyMotionRequest& request) { return *request.mutable_trajectories(0)->mutable_knots(); }

TEST(ReadTrajectories, NamesEachViolationWithItsFieldPathAndRemedy) {
  const std::vector<VerifyCase> cases = {
      {"three", [](auto& r) { *r.add_trajectories() = r.trajectories(0); }, "trajectories", "has 3 entries"},
      {"short column", [](auto& r) { knots(r).mutable_position_rad()->RemoveLast(); },
       "trajectories[0].knots.position_rad", "has 1 entries, must have 2 as time_s has"},
      {"long column", [](auto& r) { knots(r).add_torque_newton_meters(0.0); },
       "trajectories[0].knots.torque_newton_meters", "has 3 entries"},
      {"NaN", [](auto& r) { knots(r).set_velocity_rad_per_s(1, kNan); }, "trajectories[0].knots.velocity_rad_per_s[1]",
       "is nan, must be finite"},
      {"infinite", [](auto& r) { knots(r).set_time_s(1, kInfinity); }, "trajectories[0].knots.time_s[1]", "is inf"},
      {"too many", [](auto& r) { knots(r).mutable_time_s()->Resize(50001, 0.0); }, "trajectories[0].knots.time_s",
       "has 50001 entries, must have at most 50000"},
      {"arc without kind", [](auto& r) { r.mutable_trajectories(1)->add_arcs(); }, "trajectories[1].arcs[0].kind",
       "is 0, must be ARC_KIND_ACCELERATE"},
      {"duration", [](auto& r) { r.mutable_trajectories(1)->set_duration_s(kNan); }, "trajectories[1].duration_s",
       "is nan"},
      {"clearance", [](auto& r) { r.set_clearance_m(-1.0); }, "clearance_m", "is -1"},
  };
  for (const VerifyCase& expected : cases) expect_violation(paper_verify_request(), expected);
}

TEST(ReadTrajectories, OrdersTrajectoriesAsTheArms) {
  wire::VerifyMotionRequest request = paper_verify_request();
  request.mutable_trajectories()->SwapElements(0, 1);
  const auto parsed = parse(request);
  const auto& wish = std::get<VerifyWish>(parsed);
  EXPECT_EQ(wish.trajectory[0].arm, "left");
  EXPECT_EQ(wish.trajectory[0].knots[0].position, 1.0);
  EXPECT_EQ(wish.trajectory[1].arm, "right");
  EXPECT_FALSE(wish.check_end_states);
}

TEST(ReadTrajectories, LeavesWrongAndMissingArmsToTheVerifier) {
  wire::VerifyMotionRequest request = paper_verify_request();
  request.mutable_trajectories(1)->set_arm("left");
  const auto doubled = parse(request);
  EXPECT_EQ(std::get<VerifyWish>(doubled).trajectory[1].arm, "left");
  request.mutable_trajectories()->RemoveLast();
  const auto missing = parse(request);
  EXPECT_EQ(std::get<VerifyWish>(missing).trajectory[1].arm, "");
}

}  // namespace
}  // namespace dualarm

#include "core/refusal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/coordination/forbidden_set.h"
#include "core/wording.h"
#include "geometry/chain.h"
#include "geometry/clearance.h"
#include "geometry/motion_bound.h"
#include "geometry/support.h"

namespace dualarm {
namespace {

struct PlacedPair {
  std::string first;
  std::string second;
  double distance = 0.0;
  bool at_goal = false;
};

/// A body in the world with the ball around it: FCL is only asked about what could be the closest.
struct PlacedBody {
  const Body* body;
  Shape shape;
  Eigen::Vector3d middle;
  double radius;  ///< m
};

PlacedBody placed_body(const Body& body, const Eigen::Isometry3d& pose) {
  Shape shape = placed(body.shape, pose);
  const Eigen::Vector3d middle = centre(shape);
  return {&body, std::move(shape), middle, bounding_radius(body.shape)};
}

std::vector<PlacedBody> placed_bodies(const std::vector<Body>& bodies, const Eigen::Isometry3d& pose) {
  std::vector<PlacedBody> all;
  all.reserve(bodies.size());
  for (const Body& body : bodies) all.push_back(placed_body(body, pose));
  return all;
}

/// Objects on tracks, where they are as the plan begins.
std::vector<PlacedBody> placed_at_begin(const std::vector<TrackedBody>& tracked) {
  std::vector<PlacedBody> all;
  for (const TrackedBody& object : tracked) all.push_back(placed_body(object.body, object.track->pose_at(0.0)));
  return all;
}

/// The closest two bodies that must not meet, of start and goal. Objects on tracks may be anywhere at the end.
std::optional<PlacedPair> closest_pair(const Problem& problem) {
  const std::array<std::vector<Body>, kArmCount> moving = {moving_bodies(problem, 0), moving_bodies(problem, 1)};
  const std::vector<Body> standing = fixed_bodies(problem);
  const std::vector<PlacedBody> fixed = placed_bodies(standing, Eigen::Isometry3d::Identity());
  const std::vector<TrackedBody> tracked = tracked_bodies(problem);
  const std::vector<PlacedBody> at_begin = placed_at_begin(tracked);
  std::optional<PlacedPair> closest;
  for (const bool at_goal : {false, true}) {
    const auto consider = [&](const std::vector<PlacedBody>& some, const std::vector<PlacedBody>& others) {
      for (const PlacedBody& first : some) {
        for (const PlacedBody& second : others) {
          const double at_least = distance_to_ball(first.shape, second.middle, second.radius);
          if (closest && at_least > closest->distance) continue;
          const double distance = clearance(first.shape, second.shape).distance;
          if (!closest || distance < closest->distance) {
            closest = {first.body->name, second.body->name, distance, at_goal};
          }
        }
      }
    };
    const auto placed_arm = [&](int arm) {
      const Task& task = problem.tasks[arm];
      return placed_bodies(moving[arm],
                           link_pose(problem.arms[arm].base, at_goal ? task.goal.position : task.start.position));
    };
    const std::vector<PlacedBody> of_first = placed_arm(0);
    const std::vector<PlacedBody> of_second = placed_arm(1);
    consider(of_first, of_second);
    consider(of_first, fixed);
    consider(of_second, fixed);
    if (at_goal) continue;
    consider(of_first, at_begin);
    consider(of_second, at_begin);
  }
  return closest;
}

}  // namespace

double end_state_slack(const Problem& problem) {
  const std::optional<PlacedPair> pair = closest_pair(problem);
  return pair ? pair->distance - problem.options.clearance : std::numeric_limits<double>::infinity();
}

Infeasible refuse_end_states(const Problem& problem, double margin) {
  const PlacedPair pair = closest_pair(problem).value();
  const char* where = pair.at_goal ? "goal" : "start";
  Evidence evidence;
  evidence.first_body = pair.first;
  evidence.second_body = pair.second;
  evidence.depth = problem.options.clearance + margin - pair.distance;
  evidence.relaxation = evidence.depth;
  return {pair.at_goal ? InfeasibleReason::kGoalInCollision : InfeasibleReason::kStartInCollision,
          worded("In the ", where, ", ", pair.first, " and ", pair.second, " are ", pair.distance, " m apart; ",
                 problem.options.clearance, " m are demanded, and ", margin, " m more for the proof; move the ", where,
                 " or demand less clearance."),
          evidence};
}

std::optional<Infeasible> refuse_paper_set(const Problem& problem, double clearance) {
  if (problem.options.region_model != RegionModel::kPaper) return std::nullopt;
  const ForbiddenSet forbidden(problem, clearance);
  for (const bool at_goal : {false, true}) {
    const auto position = [&](int i) {
      return at_goal ? problem.tasks[i].goal.position : problem.tasks[i].start.position;
    };
    if (!forbidden.contains(position(0), position(1))) continue;
    Evidence evidence;
    evidence.first_body = problem.arms[0].name;
    evidence.second_body = problem.arms[1].name;
    return Infeasible{at_goal ? InfeasibleReason::kGoalInCollision : InfeasibleReason::kStartInCollision,
                      worded("The ", at_goal ? "goal" : "start", " (", degrees(position(0)), ", ", degrees(position(1)),
                             ") deg lies in the paper's forbidden set R_c, although the arms "
                             "keep their clearance there; ask for REGION_MODEL_EXACT."),
                      evidence};
  }
  return std::nullopt;
}

std::optional<Infeasible> refuse_sweeps(const Problem& problem, double margin) {
  const double demanded = problem.options.clearance;
  const std::vector<Body> fixed = fixed_bodies(problem);
  for (int i = 0; i < kArmCount; ++i) {
    const auto [low, high] = std::minmax({problem.tasks[i].start.position, problem.tasks[i].goal.position});
    for (const Body& moving : moving_bodies(problem, i)) {
      for (const Body& standing : fixed) {
        if (swept_gap(problem.arms[i].base, moving.shape, standing.shape) > demanded + margin) continue;
        const IntervalSet blocked =
            blocked_positions(problem.arms[i].base, moving.shape, standing.shape, demanded + margin, {low, high});
        if (blocked.empty()) continue;
        const Interval first = blocked.intervals().front();
        Evidence evidence;
        evidence.arm = problem.arms[i].name;
        evidence.position = first.lower;
        evidence.first_body = moving.name;
        evidence.second_body = standing.name;
        return Infeasible{
            InfeasibleReason::kObjectInSweep,
            worded(standing.name, " stands in the way of ", moving.name, ": with ", problem.arms[i].name, " from ",
                   first.lower, " to ", first.upper, " rad, between start and goal, they are closer than the demanded ",
                   demanded, " m and the ", margin, " m more for the proof; move the object or the goal."),
            evidence};
      }
    }
  }
  return std::nullopt;
}

Infeasible refuse_delays(const Problem& problem, const IntervalSet& safe_delays) {
  const double allowed = problem.options.max_start_delay;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Interval& safe : safe_delays.intervals()) {
    smallest = std::min(smallest, std::abs(std::clamp(0.0, safe.lower, safe.upper)));
  }
  Evidence evidence;
  if (std::isfinite(smallest)) evidence.relaxation = smallest - allowed;
  return {InfeasibleReason::kNoCoordination,
          std::isfinite(smallest)
              ? worded("The smallest delay that avoids a collision is ", smallest, " s, and ", allowed,
                       " s and the named methods are allowed; allow more delay or more methods.")
              : worded("Whichever arm waits, and however long, the fastest motions collide, and no other method is "
                       "allowed; allow METHOD_STATE_TIME, which needs REGION_MODEL_EXACT."),
          evidence};
}

Infeasible refuse_parted(const Problem& problem) {
  const std::string& first = problem.arms[0].name;
  const std::string& second = problem.arms[1].name;
  Evidence evidence;
  evidence.first_body = first;
  evidence.second_body = second;
  return {InfeasibleReason::kNoCoordination,
          worded("Inside the joint ranges no path leads from the start to the goal on which ", first, " and ", second,
                 " keep their clearance, however slow they are and whoever gives way; widen the joint ranges, or move "
                 "the start or the goal to the same side of the other arm."),
          evidence};
}

}  // namespace dualarm

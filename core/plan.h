#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/model/interval_set.h"
#include "core/model/problem.h"
#include "core/model/trajectory.h"
#include "core/passage/gate.h"
#include "core/verification/verify.h"

namespace dualarm {

/// How strong the statement about a plan's duration is. Theory, section 4.
enum class Claim {
  kOptimal,          ///< no motion of any kind is faster that keeps the demanded clearance and the planning margin
  kOptimalMonotone,  ///< none is faster among motions in which neither arm turns back
  kGap,              ///< the duration is at most `gap` above the lower bound
};

/// Where the lower bound comes from.
enum class LowerBoundSource {
  kFastestMotions,  ///< the slower arm's fastest motion on its own
  kPassage,         ///< theory, section 4
  kMovingObject,    ///< that is in the way, or passes a goal late; theory, sections 3 and 4
};

/// A moving object at a place where an arm has to pass, or to rest.
struct ObjectVisit {
  int arm = 0;
  double position = 0.0;  ///< rad, of the arm there
  std::string object;
  std::string body;    ///< of the arm: its link or what it carries
  double until = 0.0;  ///< s since the start of the plan; infinite where the object stays there
};

struct Certificate {
  double lower_bound = 0.0;  ///< s, of every plan that keeps the demanded clearance
  double gap = 0.0;          ///< duration / lower_bound - 1, >= 0; 0 where nothing has to move
  Claim claim = Claim::kGap;
  LowerBoundSource source = LowerBoundSource::kFastestMotions;
  std::optional<Gate> gate;          ///< of a passage bound
  std::optional<ObjectVisit> visit;  ///< of a moving object's bound
  IntervalSet safe_start_delays;     ///< s, start of arm 2 minus start of arm 1, for both arms' fastest motions; moving
                                     ///< objects left out
};

/// A verified motion of both arms.
struct Plan {
  double duration = 0.0;  ///< s
  Method method = Method::kSimultaneous;
  Trajectory trajectory;
  Certificate certificate;
  Verification verification;
};

/// Why there is no plan, proven.
enum class InfeasibleReason {
  kStartInCollision,
  kGoalInCollision,
  kStartOutsideRange,
  kGoalOutsideRange,
  kStartNotHoldable,
  kGoalNotHoldable,
  kTorqueTooSmall,  ///< no motion gets past an angle
  kStartTooFast,    ///< the start's velocity breaks its limit or cannot be braked inside the joint's free range
  kGoalTooFast,     ///< the goal's velocity breaks its limit or cannot be reached inside the joint's free range
  kVelocityLimit,   ///< the limit cannot be kept even with full braking
  kObjectInSweep,   ///< a fixed object stands in the arm's way
  kNoCoordination,  ///< no allowed way of taking turns exists
};

/// What an infeasibility rests on. Fields that do not apply are empty.
struct Evidence {
  std::string arm;
  std::optional<double> position;          ///< rad
  std::optional<double> velocity;          ///< rad/s, at that position
  std::optional<double> needed_torque;     ///< N m
  std::optional<double> available_torque;  ///< N m
  std::string first_body;
  std::string second_body;
  std::optional<double> depth;       ///< m, by how much the demanded clearance is missed
  std::optional<double> relaxation;  ///< smallest change of the limit that would help, in the unit of the limit
};

struct Infeasible {
  InfeasibleReason reason = InfeasibleReason::kNoCoordination;
  std::string explanation;  ///< a sentence with names, values and the remedy
  Evidence evidence;
};

/// No plan was found and none is excluded.
struct Undecided {
  std::string explanation;         ///< what was tried, and what could help
  std::vector<std::string> tried;  ///< one line a method
  double seconds_spent = 0.0;      ///< s
  double best_lower_bound = 0.0;   ///< s, 0 if none is known
};

/// What a planning run cost.
struct Statistics {
  double planning_seconds = 0.0;
  double analytic_seconds = 0.0;
  double fallback_seconds = 0.0;
  double verification_seconds = 0.0;
  int distance_query_count = 0;
  int fallback_evaluation_count = 0;
  int fallback_node_count = 0;            ///< of the search's largest tree
  std::size_t fallback_memory_bytes = 0;  ///< that its nodes took
};

struct Outcome {
  std::variant<Plan, Infeasible, Undecided> answer;
  Statistics statistics;
};

}  // namespace dualarm

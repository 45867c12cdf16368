#include "core/analytic_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/certify.h"
#include "core/coordination/diagram.h"
#include "core/object_visit.h"
#include "core/passage/passage_plan.h"
#include "core/passage/proof.h"
#include "core/passage/traffic_proof.h"
#include "core/passage_choice.h"
#include "core/phase_plane/time_optimal.h"
#include "core/proven_plan.h"
#include "core/refusal.h"
#include "core/refuse_blocked.h"
#include "core/search_planner.h"
#include "core/start_choice.h"

namespace dualarm {
namespace {

/// Part of the time left that the search for an arm's fastest motion may take: what is found has to be put together.
constexpr double kFastestMotionShare = 0.5;
/// Part of the time left that bounds may take: plans have to be found in the rest.
constexpr double kBoundShare = 0.3;

class AnalyticPlanner {
 public:
  AnalyticPlanner(const PreparedProblem& prepared, const PlanningBudget& budget, Findings& findings)
      : prepared_(prepared), problem_(prepared.problem()), budget_(budget), findings_(findings) {}

  std::optional<Decision> decision() {
    findings_.begin("fastest motions");
    for (int arm = 0; arm < kArmCount; ++arm) {
      if (auto refusal = move_alone(arm)) return refusal;
    }
    if (prepared_.slack() < prepared_.margin()) return refuse_end_states(problem_, prepared_.margin());
    if (auto refusal = refuse_paper_set(problem_, prepared_.clearance())) return *refusal;
    if (auto refusal = refuse_sweeps(problem_, prepared_.margin())) return *refusal;
    if (auto refusal = await_goal_visits()) return *refusal;
    if (fastest_.size() < kArmCount) return std::nullopt;
    bound_by_monotone_motions();
    return coordinate();
  }

 private:
  /// An arm's fastest motion with nothing in its way, or why it has none.
  std::optional<Decision> move_alone(int arm) {
    const Task& task = problem_.tasks[arm];
    const SingleJointArm& system = prepared_.system(arm);
    auto motion =
        fastest_motion(system, task.start, task.goal, Swings::kSearch, budget_.methods.part(kFastestMotionShare));
    double& bound = findings_.bounds.fastest;
    if (const auto* blocked = std::get_if<Blocked>(&motion)) {
      const Infeasible refusal =
          refuse_blocked(prepared_.arm(arm), task, system, prepared_.free_range(arm), *blocked, budget_.methods);
      if (blocked->is_proven) return refusal;
      findings_.tried.push_back(refusal.explanation +
                                (blocked->is_searched_out
                                     ? " Motions that swing to and fro were searched too, without success."
                                     : " Time ran out in the search for motions that swing to and fro."));
      bound = std::max(bound, blocked->lower_bound);
    } else {
      fastest_.push_back(std::get<FastestMotion>(std::move(motion)));
      bound = std::max(bound, proven_duration(arm, fastest_.back()));
    }
    return std::nullopt;
  }

  /// What no motion of an arm is faster than, s.
  double proven_duration(int arm, const FastestMotion& fastest) const {
    if (fastest.minimum_over == MinimumOver::kAllMotions) return fastest.lower_bound;
    return std::max(fastest.lower_bound, fastest_proof(problem_, arm, fastest.profile.duration()));
  }

  /// No plan ends before the last moving object has passed the goals.
  std::optional<Infeasible> await_goal_visits() {
    const auto planned = last_goal_visit(problem_, prepared_.clearance(), budget_.methods);
    if (!planned) return std::nullopt;
    if (std::isinf(planned->until)) return refuse_visit(problem_, *planned, prepared_.margin());
    findings_.bounds.planned_visit = planned->until;
    if (const auto visit = last_goal_visit(problem_, problem_.options.clearance, budget_.methods)) {
      findings_.bounds.visit = VisitBound{visit->until, *visit};
    }
    return std::nullopt;
  }

  /// Moving objects may be in an arm's way. `known` (s) is the duration of a plan, infinite where there is none. The
  /// refusal of one that stays.
  std::optional<Infeasible> bound_by_traffic(double known) {
    KnownBounds& bounds = findings_.bounds;
    const double least = std::max(bounds.of_every_plan(), bounds.planned_visit);
    if (!prepared_.has_moving_objects() || known <= least) return std::nullopt;
    const auto planned = traffic_proof(problem_, prepared_.clearance(), bounds.planned_visit, known, budget_.methods);
    if (!planned) return std::nullopt;
    const auto visit = [this](const TrafficProof& proof, double clearance) {
      return visit_until(problem_, proof.arm, proof.position, clearance, proof.until, budget_.methods);
    };
    if (std::isinf(planned->duration)) {
      return refuse_visit(problem_, visit(*planned, prepared_.clearance()), prepared_.margin());
    }
    bounds.planned_visit = planned->duration;
    const double demanded = problem_.options.clearance;
    const auto found = traffic_proof(problem_, demanded, bounds.of_every_plan(), known, budget_.methods);
    if (found) bounds.visit = {found->duration, visit(*found, demanded)};
    return std::nullopt;
  }

  void bound_by_monotone_motions() {
    for (const FastestMotion& motion : fastest_) {
      if (motion.minimum_over == MinimumOver::kSearchedMotions) continue;
      findings_.bounds.monotone = std::max(findings_.bounds.monotone, motion.profile.duration());
    }
  }

  /// Of the fastest motions, s.
  double slower_duration() const { return std::max(fastest_[0].profile.duration(), fastest_[1].profile.duration()); }

  /// Waiting, or a passage where that is faster. Theory, sections 3 and 4.
  std::optional<Decision> coordinate() {
    findings_.begin("start delays");
    if (may_meet(prepared_.forbidden(), fastest_[0].profile, fastest_[1].profile)) {
      for (FastestMotion& motion : fastest_) motion.profile = motion.profile.asked_often();
    }
    const StartChoice choice = starts_of(fastest_[0].profile, fastest_[1].profile);
    findings_.safe_delays = choice.safe_delays;
    if (!choice.times && knows_start_times()) findings_.tried.push_back(choice.why_not);
    const double known = choice.times ? choice.times->duration : std::numeric_limits<double>::infinity();
    if (auto refusal = bound_by_traffic(known)) return *refusal;
    const double longest = std::max(slower_duration(), findings_.bounds.planned_visit);
    if (known > longest * (1.0 + kAtBound)) bound_by_passage();
    if (is_parted_) return refuse_parted(problem_);
    const double passage = findings_.passages ? findings_.passages->bound.duration : 0.0;
    if (known > std::max(longest, passage) * (1.0 + kAtBound)) {
      if (auto found = pass(known)) return *std::move(found);
    }
    if (choice.times) {
      PassagePlan plan = {{std::move(fastest_[0].profile), std::move(fastest_[1].profile)}, *choice.times};
      const Method method = method_of(plan.times);
      if (auto found = verified(method, std::move(plan))) return found;
      return std::nullopt;
    }
    return refusal_of_delays();
  }

  /// Proven only where other motions than the fastest, which might take turns, are not allowed.
  std::optional<Decision> refusal_of_delays() const {
    const bool knows_more = allows_search(problem_.options) || problem_.options.allows(Method::kPassage);
    if (!findings_.safe_delays || knows_more || prepared_.has_moving_objects()) return std::nullopt;
    if (!prepared_.rests_at_ends() || was_searched()) return std::nullopt;
    return refuse_delays(problem_, *findings_.safe_delays);
  }

  /// Whether a motion is the fastest of those that were searched only.
  bool was_searched() const {
    return std::any_of(fastest_.begin(), fastest_.end(), [](const FastestMotion& motion) {
      return motion.minimum_over == MinimumOver::kSearchedMotions;
    });
  }

  /// Whether a method is allowed for which there are start times.
  bool knows_start_times() const {
    const PlanOptions& options = problem_.options;
    return options.allows(Method::kSimultaneous) || options.allows(Method::kDelay) || options.allows(Method::kPassage);
  }

  StartChoice starts_of(const Profile& first, const Profile& second) const {
    return choose_starts(problem_, prepared_.forbidden(), prepared_.clearance(), first, second, budget_.methods);
  }

  /// Delays are the simplest motions through a passage.
  Method method_of(const StartTimes& times) const {
    const bool waits = times.first + times.second > 0.0;
    if (!waits && problem_.options.allows(Method::kSimultaneous)) return Method::kSimultaneous;
    return problem_.options.allows(Method::kDelay) ? Method::kDelay : Method::kPassage;
  }

  /// What passages tell of plans that keep the planning margin, and of all that keep the demanded clearance.
  void bound_by_passage() {
    if (budget_.methods.exhausted()) return;
    findings_.begin("passage");
    const Budget budget = budget_.methods.part(kBoundShare);
    findings_.passages.emplace(Passages{{traveller(0), traveller(1)}, {}});
    const Travellers& travellers = findings_.passages->travellers;
    const Problem planned = prepared_.within_free_ranges_at(prepared_.clearance());
    const PassageBound& bound = findings_.passages->bound =
        passage_bound(ForbiddenPlane(planned, prepared_.clearance()), travellers, budget);
    findings_.bounds.planned = proof_of(bound, planned);
    const double demanded = problem_.options.clearance;
    const Problem free = prepared_.within_free_ranges_at(demanded);
    is_parted_ = std::isinf(bound.duration) &&
                 std::isinf(passage_bound(ForbiddenPlane(free, demanded), travellers, budget).duration);
    if (std::isfinite(bound.duration)) {
      findings_.bounds.demanded = passage_proof(free, demanded, bound.duration, budget, bound.ways);
    }
  }

  Traveller traveller(int arm) const {
    return {&prepared_.system(arm), problem_.tasks[arm].start, problem_.tasks[arm].goal, fastest_[arm].profile};
  }

  /// The fastest motions found through a passage, if they take less than `known` (s). Theory, section 4.
  std::optional<Plan> pass(double known) {
    if (!problem_.options.allows(Method::kPassage)) return std::nullopt;
    if (!findings_.passages || findings_.passages->bound.ways.empty()) {
      findings_.tried.push_back("passage: no gate was found that the arms have to pass in turn");
      return std::nullopt;
    }
    if (auto found = pass_extremally()) return found;
    if (auto best = fastest_passage(prepared_, *findings_.passages, known, budget_.methods)) {
      return verified(Method::kPassage, *std::move(best));
    }
    findings_.tried.push_back("passage: no motions through it were found that are free and faster than a delay");
    return std::nullopt;
  }

  /// The extremal motions through the fastest way, if they are free. Verification tells that faster than a search.
  std::optional<Plan> pass_extremally() {
    auto extremal = extremal_plan(findings_.passages->travellers, findings_.passages->bound.ways.front(),
                                  slower_duration(), problem_.options.max_start_delay);
    if (!extremal || prepared_.has_moving_objects() || budget_.methods.exhausted()) return std::nullopt;
    const std::size_t tried = findings_.tried.size();
    if (auto found = verified(Method::kPassage, *std::move(extremal))) return found;
    findings_.tried.resize(tried);
    return std::nullopt;
  }

  std::optional<Plan> verified(Method method, PassagePlan plan) {
    const double duration = plan.times.duration;
    Schedule schedule = schedule_of(std::move(plan));
    auto found = proven_plan(prepared_, method, duration, schedule, budget_.proof, findings_);
    if (found) findings_.analytic = KnownSchedule{std::move(schedule), duration};
    return found;
  }

  const PreparedProblem& prepared_;
  const Problem& problem_;
  const PlanningBudget& budget_;
  Findings& findings_;
  std::vector<FastestMotion> fastest_;
  bool is_parted_ = false;  ///< no path leads from the start to the goal
};

}  // namespace

std::optional<Decision> plan_analytically(const PreparedProblem& prepared, const PlanningBudget& budget,
                                          Findings& findings) {
  return AnalyticPlanner(prepared, budget, findings).decision();
}

}  // namespace dualarm

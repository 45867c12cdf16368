#include "core/planner.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <sstream>

#include "core/coordination/diagram.h"
#include "core/coordination/start_times.h"
#include "core/fallback/state_time_planner.h"
#include "core/phase_plane/time_optimal.h"
#include "core/refusal.h"
#include "core/systems/playback.h"

namespace dualarm {
namespace {

/// Added to the demanded clearance while planning, m: optimal plans touch the forbidden set, and the proof that they
/// keep the demanded clearance ends only if there is some room (theory, section 5). Where the start or the goal leaves
/// less, half of what it leaves, but not less than the proof needs on arms of any size.
constexpr double kPlanningMargin = 1e-4;
constexpr double kLeastMargin = 1e-5;
/// How long a plan found when the budget ends may take to be proven.
constexpr std::chrono::milliseconds kVerificationGrace(250);
/// Most knot periods a plan may last: what is sent stays below the 50,000 knots an arm that a message may hold.
constexpr double kMostKnots = 49000.0;
/// A plan this close to its lower bound, relative, is at it: rounding of quadratures and sums.
constexpr double kAtBound = 1e-9;

double seconds_since(Budget::Clock::time_point start) {
  return std::chrono::duration<double>(Budget::Clock::now() - start).count();
}

/// One planning run: its problem, what was found out so far, and what it cost.
class Run {
 public:
  Run(const Problem& problem, const Budget& budget)
      : problem_(problem),
        budget_(budget),
        arms_{loaded_arm(problem, 0), loaded_arm(problem, 1)},
        systems_{SingleJointArm(arms_[0]), SingleJointArm(arms_[1])} {}

  Outcome answer() {
    auto found = analytic();
    statistics_.analytic_seconds = seconds_since(begin_) - statistics_.verification_seconds;
    if (!found) found = search();
    statistics_.planning_seconds = seconds_since(begin_);
    return {found ? std::move(*found) : undecided(), statistics_};
  }

 private:
  using Answer = decltype(Outcome::answer);

  std::optional<Answer> analytic() {
    for (int i = 0; i < kArmCount; ++i) {
      const Task& task = problem_.tasks[i];
      auto motion = fastest_motion(systems_[i], task.start.position, task.goal.position);
      if (const auto* blocked = std::get_if<Blocked>(&motion)) {
        const Infeasible refusal = refuse_blocked(arms_[i], systems_[i], *blocked);
        if (blocked->is_proven) return refusal;
        tried_.push_back(refusal.explanation + " Swinging back first might help.");
        lower_bound_ = std::max(lower_bound_, blocked->lower_bound);
      } else {
        fastest_.push_back(std::get<FastestMotion>(std::move(motion)));
        lower_bound_ = std::max(lower_bound_, fastest_.back().lower_bound);
      }
    }
    const double slack = end_state_slack(problem_);
    margin_ = std::clamp(0.5 * slack, kLeastMargin, kPlanningMargin);
    if (slack < margin_) return refuse_end_states(problem_, margin_);
    if (auto refusal = refuse_paper_set(problem_, clearance())) return *refusal;
    if (auto refusal = refuse_sweeps(problem_, margin_)) return *refusal;
    if (fastest_.size() < kArmCount) return std::nullopt;
    return wait();
  }

  /// What is planned with, m: the demanded clearance and the margin.
  double clearance() const { return problem_.options.clearance + margin_; }

  /// The fastest motions, one of them delayed where they would collide. Theory, section 3.
  std::optional<Answer> wait() {
    const PlanOptions& options = problem_.options;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Profile& first = fastest_[0].profile;
    const Profile& second = fastest_[1].profile;
    const auto forbidden = forbidden_delays(ForbiddenSet(problem_, clearance()), first, second, budget_);
    if (!forbidden) {
      tried_.push_back("start delays: the budget ran out");
      return std::nullopt;
    }
    safe_delays_ = forbidden->complement({-kInfinity, kInfinity});
    const double longest = options.allows(Method::kDelay)          ? options.max_start_delay
                           : options.allows(Method::kSimultaneous) ? 0.0
                                                                   : -1.0;
    if (const auto times = best_start_times(safe_delays_, first.duration(), second.duration(), longest)) {
      const bool waits = times->first + times->second > 0.0 || !options.allows(Method::kSimultaneous);
      return verified(waits ? Method::kDelay : Method::kSimultaneous, times->duration,
                      {std::vector{TimedProfile{times->first, first}}, {TimedProfile{times->second, second}}});
    }
    tried_.push_back("start delays: none that is allowed avoids a collision of the fastest motions");
    if (!may_search()) return refuse_delays(problem_, safe_delays_);
    return std::nullopt;
  }

  /// The search knows the exact set only.
  bool may_search() const {
    return problem_.options.allows(Method::kStateTime) && problem_.options.region_model == RegionModel::kExact;
  }

  /// Motions with rests on the way, by search. Theory, section 6.
  std::optional<Answer> search() {
    if (!may_search()) return std::nullopt;
    const auto start = Budget::Clock::now();
    const SearchResult result =
        search_state_time(problem_, {&systems_[0], &systems_[1]}, clearance(), kDefaultEvaluationLimit, budget_);
    statistics_.fallback_seconds = seconds_since(start);
    statistics_.fallback_evaluation_count = result.evaluation_count;
    std::ostringstream line;
    line << "state-time search: " << result.evaluation_count << " evaluations, "
         << (result.schedule ? "a schedule found" : "no schedule found")
         << (result.budget_ran_out ? ", stopped by the budget" : "");
    tried_.push_back(line.str());
    if (!result.schedule) return std::nullopt;
    return verified(Method::kStateTime, result.duration, *result.schedule);
  }

  /// The motions as they are sent, if they pass verification; nothing else leaves the house.
  std::optional<Answer> verified(Method method, double duration, const Schedule& schedule) {
    if (duration / problem_.options.knot_period > kMostKnots) {
      std::ostringstream line;
      line << "A plan of " << duration << " s was found, but at a knot period of " << problem_.options.knot_period
           << " s it has more than " << kMostKnots << " knots an arm; ask for a longer knot period";
      remedy_ = line.str();
      return undecided();
    }
    Plan plan;
    plan.duration = duration;
    plan.method = method;
    for (int i = 0; i < kArmCount; ++i) {
      plan.trajectory[i] = play(arms_[i], systems_[i], schedule[i], duration, problem_.options.knot_period);
    }
    if (std::max(plan.trajectory[0].start_time, plan.trajectory[1].start_time) > problem_.options.max_start_delay) {
      tried_.push_back("the schedule found has an arm wait longer than the largest start delay allowed");
      return std::nullopt;
    }
    const auto start = Budget::Clock::now();
    // A search may have used up the budget; proving what it found takes milliseconds.
    plan.verification = verify(problem_, plan.trajectory, budget_.with_grace(kVerificationGrace));
    statistics_.verification_seconds += seconds_since(start);
    statistics_.distance_query_count += plan.verification.distance_query_count;
    if (!plan.verification.holds()) {
      tried_.push_back("a plan was found but not verified: " + plan.verification.violations.front().explanation);
      return std::nullopt;
    }
    plan.certificate = certificate(method, duration);
    return plan;
  }

  Certificate certificate(Method method, double duration) const {
    Certificate certificate;
    certificate.lower_bound = lower_bound_;
    certificate.gap = duration > 0.0 ? std::max(0.0, duration / lower_bound_ - 1.0) : 0.0;
    if (method != Method::kStateTime) certificate.safe_start_delays = safe_delays_;
    double monotone_bound = 0.0;
    for (const FastestMotion& motion : fastest_) monotone_bound = std::max(monotone_bound, motion.profile.duration());
    if (duration <= lower_bound_ * (1.0 + kAtBound)) {
      certificate.claim = Claim::kOptimal;
    } else if (fastest_.size() == kArmCount && duration <= monotone_bound * (1.0 + kAtBound)) {
      certificate.claim = Claim::kOptimalMonotone;
    }
    return certificate;
  }

  Answer undecided() const {
    Undecided answer;
    answer.explanation = remedy_;
    answer.tried = tried_;
    answer.seconds_spent = seconds_since(begin_);
    answer.best_lower_bound = lower_bound_;
    return answer;
  }

  const Problem& problem_;
  const Budget& budget_;
  std::array<Arm, kArmCount> arms_;
  std::array<SingleJointArm, kArmCount> systems_;
  Budget::Clock::time_point begin_ = Budget::Clock::now();
  std::vector<FastestMotion> fastest_;
  double lower_bound_ = 0.0;         ///< s, of every plan
  double margin_ = kPlanningMargin;  ///< m
  IntervalSet safe_delays_;
  std::vector<std::string> tried_;
  std::string remedy_ =
      "No plan was found and none is excluded; allow more methods or a larger planning budget, or try another seed.";
  Statistics statistics_;
};

}  // namespace

Outcome plan(const Problem& problem, const Budget& budget) { return Run(problem, budget).answer(); }

}  // namespace dualarm

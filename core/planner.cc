#include "core/planner.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/certify.h"
#include "core/fallback/state_time_planner.h"
#include "core/free_range.h"
#include "core/passage/passage_plan.h"
#include "core/passage/proof.h"
#include "core/phase_plane/time_optimal.h"
#include "core/refusal.h"
#include "core/refuse_blocked.h"
#include "core/start_choice.h"
#include "core/systems/playback.h"
#include "core/wording.h"

namespace dualarm {
namespace {

/// Added to the demanded clearance while planning, m: optimal plans touch the forbidden set, and the proof that they
/// keep the demanded clearance ends only if there is some room (theory, section 5). Where the start or the goal leaves
/// less, half of what it leaves, but not less than the proof needs on arms of any size.
constexpr double kPlanningMargin = 1e-4;
constexpr double kLeastMargin = 1e-5;
/// Part of the time left that the search for an arm's fastest motion may take: what is found has to be put together.
constexpr double kFastestMotionShare = 0.5;
/// How long a plan found when the budget ends may take to be proven.
constexpr std::chrono::milliseconds kVerificationGrace(250);
/// Most knot periods a plan may last: what is sent stays below the 50,000 knots an arm that a message may hold.
constexpr double kMostKnots = 49000.0;

double seconds_since(Budget::Clock::time_point start) {
  return std::chrono::duration<double>(Budget::Clock::now() - start).count();
}

bool is_at_rest(const Task& task) { return task.start.velocity == 0.0 && task.goal.velocity == 0.0; }

/// An arm that no motion takes out of the stretch that fixed objects leave it.
SingleJointArm system_within(Arm arm, const FreeRange& free) {
  arm.joint_range = free.range;
  return SingleJointArm(arm);
}

/// One planning run: its problem, what was found out so far, and what it cost.
class Run {
 public:
  Run(const Problem& problem, const Budget& budget)
      : problem_(problem),
        budget_(budget),
        slack_(end_state_slack(problem)),
        margin_(std::clamp(0.5 * slack_, kLeastMargin, kPlanningMargin)),
        arms_{loaded_arm(problem, 0), loaded_arm(problem, 1)},
        free_(free_ranges(clearance())),
        systems_{system_within(arms_[0], free_[0]), system_within(arms_[1], free_[1])},
        forbidden_(problem, clearance()) {}

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
      auto motion =
          fastest_motion(systems_[i], task.start, task.goal, Swings::kSearch, budget_.part(kFastestMotionShare));
      if (const auto* blocked = std::get_if<Blocked>(&motion)) {
        const Infeasible refusal = refuse_blocked(arms_[i], task, systems_[i], free_[i], *blocked, budget_);
        if (blocked->is_proven) return refusal;
        tried_.push_back(refusal.explanation +
                         (blocked->is_searched_out
                              ? " Motions that swing to and fro were searched too, without success."
                              : " Time ran out in the search for motions that swing to and fro."));
        lower_bound_ = std::max(lower_bound_, blocked->lower_bound);
      } else {
        fastest_.push_back(std::get<FastestMotion>(std::move(motion)));
        lower_bound_ = std::max(lower_bound_, proven_duration(i, fastest_.back()));
      }
    }
    if (slack_ < margin_) return refuse_end_states(problem_, margin_);
    if (auto refusal = refuse_paper_set(problem_, clearance())) return *refusal;
    if (auto refusal = refuse_sweeps(problem_, margin_)) return *refusal;
    if (fastest_.size() < kArmCount) return std::nullopt;
    return wait();
  }

  /// What no motion of an arm is faster than, s.
  double proven_duration(int arm, const FastestMotion& fastest) const {
    if (fastest.minimum_over == MinimumOver::kAllMotions) return fastest.lower_bound;
    const double duration = fastest.profile.duration();
    return std::max(fastest.lower_bound, fastest_proof(problem_, arm, duration));
  }

  std::array<FreeRange, kArmCount> free_ranges(double clearance) const {
    return {free_range(problem_, 0, clearance), free_range(problem_, 1, clearance)};
  }

  /// Of the fastest motions, s.
  double slower_duration() const { return std::max(fastest_[0].profile.duration(), fastest_[1].profile.duration()); }

  /// What is planned with, m: the demanded clearance and the margin.
  double clearance() const { return problem_.options.clearance + margin_; }

  /// The fastest motions, one of them delayed where they would collide; or motions through a passage, where those are
  /// faster or no delay exists. Theory, sections 3 and 4.
  std::optional<Answer> wait() {
    const auto times = best_delay();
    const double longest = slower_duration();
    if (!times || times->duration > longest * (1.0 + kAtBound)) bound_by_passage();
    if (is_parted_) return refuse_parted(problem_);
    if (!times || times->duration > std::max(longest, passage_.duration) * (1.0 + kAtBound)) {
      if (auto found = pass(times ? times->duration : std::numeric_limits<double>::infinity())) return found;
    }
    if (times) {
      return verified(method_of(*times), *times, fastest_[0].profile, fastest_[1].profile);
    }
    // Other motions than the fastest might take turns, but the methods that are allowed know none.
    if (has_delays_ && !has_moving_objects_ && !knows_more_than_delays() && rests_at_ends() && !was_searched()) {
      return refuse_delays(problem_, safe_delays_);
    }
    return std::nullopt;
  }

  /// When the fastest motions begin, with the best delay that is allowed.
  std::optional<StartTimes> best_delay() {
    const StartChoice choice = starts_of(fastest_[0].profile, fastest_[1].profile);
    has_delays_ = choice.safe_delays.has_value();
    if (choice.safe_delays) safe_delays_ = *choice.safe_delays;
    if (!choice.times) tried_.push_back(choice.why_not);
    return choice.times;
  }

  StartChoice starts_of(const Profile& first, const Profile& second) const {
    return choose_starts(problem_, forbidden_, clearance(), first, second, budget_);
  }

  /// Delays are the simplest motions through a passage.
  Method method_of(const StartTimes& times) const {
    const bool waits = times.first + times.second > 0.0;
    if (!waits && problem_.options.allows(Method::kSimultaneous)) return Method::kSimultaneous;
    return problem_.options.allows(Method::kDelay) ? Method::kDelay : Method::kPassage;
  }
  bool knows_more_than_delays() const { return search_is_allowed() || problem_.options.allows(Method::kPassage); }

  /// What passages tell of plans that keep the planning margin, and of all that keep the demanded clearance.
  void bound_by_passage() {
    travellers_.emplace(Travellers{traveller(0), traveller(1)});
    const Problem planned = within_free_ranges(problem_, free_);
    passage_ = passage_bound(ForbiddenPlane(planned, clearance()), *travellers_, budget_);
    margin_proof_ = proof_of(passage_, planned);
    const double demanded = problem_.options.clearance;
    const Problem free = within_free_ranges(problem_, free_ranges(demanded));
    is_parted_ = std::isinf(passage_.duration) &&
                 std::isinf(passage_bound(ForbiddenPlane(free, demanded), *travellers_, budget_).duration);
    if (std::isfinite(passage_.duration)) {
      proof_ = passage_proof(free, demanded, passage_.duration, budget_, passage_.ways);
    }
  }

  Traveller traveller(int arm) const {
    return {&systems_[arm], problem_.tasks[arm].start, problem_.tasks[arm].goal, fastest_[arm].profile};
  }

  /// The fastest motions found through a passage, if they take less than `known` (s). Theory, section 4.
  std::optional<Answer> pass(double known) {
    if (!problem_.options.allows(Method::kPassage)) return std::nullopt;
    if (passage_.ways.empty()) {
      tried_.push_back("passage: no gate was found that the arms have to pass in turn");
      return std::nullopt;
    }
    if (auto found = pass_extremally()) return found;
    const double least = slower_duration();
    std::optional<PassagePlan> best;
    for (const Way& way : passage_.ways) {
      auto found = passage_plan(forbidden_, *travellers_, way, least, known, problem_.options.max_start_delay, budget_);
      if (!found || !gives_way_to_objects(*found, known)) continue;
      best = std::move(found);
      known = best->times.duration;
    }
    if (best) return verified(*best);
    tried_.push_back("passage: no motions through it were found that are free and faster than a delay");
    return std::nullopt;
  }

  /// Moving objects may ask for other start times, or leave none: false if the plan takes `known` (s) or more then.
  bool gives_way_to_objects(PassagePlan& plan, double known) const {
    if (!has_moving_objects_) return true;
    const StartChoice choice = starts_of(plan.motions[0], plan.motions[1]);
    if (choice.times) plan.times = *choice.times;
    return choice.times && choice.times->duration < known;
  }

  /// The extremal motions through the fastest way, if they are free. Verification tells that faster than a search.
  std::optional<Answer> pass_extremally() {
    const auto extremal =
        extremal_plan(*travellers_, passage_.ways.front(), slower_duration(), problem_.options.max_start_delay);
    if (!extremal || has_moving_objects_ || budget_.exhausted()) return std::nullopt;
    const std::size_t tried = tried_.size();
    if (auto found = verified(*extremal)) return found;
    tried_.resize(tried);
    return std::nullopt;
  }

  std::optional<Answer> verified(const PassagePlan& plan) {
    return verified(Method::kPassage, plan.times, plan.motions[0], plan.motions[1]);
  }

  std::optional<Answer> verified(Method method, const StartTimes& times, const Profile& first, const Profile& second) {
    return verified(method, times.duration,
                    {std::vector{TimedProfile{times.first, first}}, {TimedProfile{times.second, second}}});
  }

  bool rests_at_ends() const {
    return std::all_of(problem_.tasks.begin(), problem_.tasks.end(), [](const Task& task) { return is_at_rest(task); });
  }

  /// Whether a motion is the fastest of those that were searched only.
  bool was_searched() const {
    return std::any_of(fastest_.begin(), fastest_.end(), [](const FastestMotion& motion) {
      return motion.minimum_over == MinimumOver::kSearchedMotions;
    });
  }

  /// The search knows the exact set only.
  bool search_is_allowed() const {
    return problem_.options.allows(Method::kStateTime) && problem_.options.region_model == RegionModel::kExact;
  }

  /// Motions by search. Theory, section 6.
  std::optional<Answer> search() {
    if (!search_is_allowed()) return std::nullopt;
    const auto start = Budget::Clock::now();
    SearchRules rules;
    rules.clearance = clearance();
    rules.lower_bound = std::max(lower_bound_, margin_proof_.duration);
    const Systems systems = {&systems_[0], &systems_[1]};
    const SearchResult result = search_state_time(problem_, systems, rules, budget_);
    statistics_.fallback_seconds = seconds_since(start);
    statistics_.fallback_evaluation_count = result.evaluation_count;
    tried_.push_back(worded("state-time search: ", result.evaluation_count, " evaluations, ",
                            result.schedule ? "a schedule found" : "no schedule found",
                            result.budget_ran_out ? ", stopped by the budget" : ""));
    if (!result.schedule) return std::nullopt;
    return verified(Method::kStateTime, result.duration, *result.schedule);
  }

  /// The motions as they are sent, if they pass verification; nothing else leaves the house.
  std::optional<Answer> verified(Method method, double duration, const Schedule& schedule) {
    if (duration / problem_.options.knot_period > kMostKnots) {
      remedy_ = worded("A plan of ", duration, " s was found, but at a knot period of ", problem_.options.knot_period,
                       " s it has more than ", kMostKnots, " knots an arm; ask for a longer knot period");
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
    const auto start = Budget::Clock::now();  // A search may have used up the budget; proving takes milliseconds.
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
    Certificate certificate = certify(duration, {lower_bound_, monotone_bound(), proof_, margin_proof_});
    if (method == Method::kSimultaneous || method == Method::kDelay) certificate.safe_start_delays = safe_delays_;
    return certificate;
  }

  /// What no pair of motions that never turn back is faster than, s; 0 if not known.
  double monotone_bound() const {
    double bound = 0.0;
    for (const FastestMotion& motion : fastest_) {
      if (motion.minimum_over != MinimumOver::kSearchedMotions) bound = std::max(bound, motion.profile.duration());
    }
    return fastest_.size() == kArmCount ? bound : 0.0;
  }

  Answer undecided() const {
    Undecided answer;
    answer.explanation = remedy_;
    answer.tried = tried_;
    answer.seconds_spent = seconds_since(begin_);
    answer.best_lower_bound = std::max(lower_bound_, proof_.duration);
    return answer;
  }

  const Problem& problem_;
  const Budget& budget_;
  double slack_;   ///< m, of start and goal
  double margin_;  ///< m
  std::array<Arm, kArmCount> arms_;
  std::array<FreeRange, kArmCount> free_;
  std::array<SingleJointArm, kArmCount> systems_;
  ForbiddenSet forbidden_;  ///< at the planning clearance
  Budget::Clock::time_point begin_ = Budget::Clock::now();
  std::vector<FastestMotion> fastest_;
  double lower_bound_ = 0.0;  ///< s, of every plan, by each arm's motion on its own
  std::optional<Travellers> travellers_;
  PassageBound passage_;       ///< at the planning clearance
  PassageProof margin_proof_;  ///< what is proven of it
  PassageProof proof_;         ///< at the demanded clearance
  bool is_parted_ = false;     ///< no path leads from the start to the goal
  bool has_moving_objects_ = !tracked_bodies(problem_).empty();
  bool has_delays_ = false;  ///< whether safe_delays_ is known
  IntervalSet safe_delays_;
  std::vector<std::string> tried_;
  std::string remedy_ =
      "No plan was found and none is excluded; allow more methods or a larger planning budget, or try another seed.";
  Statistics statistics_;
};

}  // namespace

Outcome plan(const Problem& problem, const Budget& budget) { return Run(problem, budget).answer(); }

}  // namespace dualarm

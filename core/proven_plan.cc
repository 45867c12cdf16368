#include "core/proven_plan.h"

#include <algorithm>
#include <chrono>

#include "core/certify.h"
#include "core/systems/playback.h"
#include "core/wording.h"

namespace dualarm {
namespace {

/// Most knot periods a plan may last: what is sent stays below the 50,000 knots an arm that a message may hold.
constexpr double kMostKnots = 49000.0;

Verification verified(const Problem& problem, const Trajectory& trajectory, const Budget& budget,
                      Statistics& statistics) {
  const auto start = Budget::Clock::now();
  Verification verification = verify(problem, trajectory, budget);
  statistics.verification_seconds += std::chrono::duration<double>(Budget::Clock::now() - start).count();
  statistics.distance_query_count += verification.distance_query_count;
  return verification;
}

Certificate certificate(Method method, double duration, const Findings& findings) {
  Certificate certificate = certify(duration, findings.bounds);
  const bool has_fastest_motions = method == Method::kSimultaneous || method == Method::kDelay;
  if (has_fastest_motions && findings.safe_delays) certificate.safe_start_delays = *findings.safe_delays;
  return certificate;
}

}  // namespace

std::optional<Plan> proven_plan(const PreparedProblem& prepared, Method method, double duration,
                                const Schedule& schedule, const Budget& budget, Findings& findings) {
  const PlanOptions& options = prepared.problem().options;
  if (duration / options.knot_period > kMostKnots) {
    findings.remedy = worded("A plan of ", duration, " s was found, but at a knot period of ", options.knot_period,
                             " s it has more than ", kMostKnots, " knots an arm; ask for a longer knot period");
    return std::nullopt;
  }
  Plan plan;
  plan.duration = duration;
  plan.method = method;
  for (int i = 0; i < kArmCount; ++i) {
    plan.trajectory[i] = play(prepared.arm(i), prepared.system(i), schedule[i], duration, options.knot_period);
  }
  if (std::max(plan.trajectory[0].start_time, plan.trajectory[1].start_time) > options.max_start_delay) {
    findings.tried.push_back("the schedule found has an arm wait longer than the largest start delay allowed");
    return std::nullopt;
  }
  plan.verification = verified(prepared.problem(), plan.trajectory, budget, findings.statistics);
  if (!plan.verification.holds()) {
    findings.tried.push_back("a plan was found but not verified: " + plan.verification.violations.front().explanation);
    return std::nullopt;
  }
  plan.certificate = certificate(method, duration, findings);
  findings.found(plan);
  return plan;
}

}  // namespace dualarm

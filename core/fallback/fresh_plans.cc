#include "core/fallback/fresh_plans.h"

#include <algorithm>
#include <utility>

namespace dualarm {
namespace {

/// Shares of arms that go straight, or by way of one state; the others go by way of two.
constexpr double kStraightShare = 0.4;
constexpr double kOneViaShare = 0.4;

/// How often a state on the way is one at rest.
constexpr double kRestShare = 0.7;

/// In multiples of the time that the busier arm needs: how long a plan may take while no other one is known.
constexpr double kFirstEnd = 4.0;

/// Plans that take this much longer than the best, relative, are no use.
constexpr double kTolerated = 1.5;

/// Plans whose durations differ by no more than this part went the same way round, as a rule.
constexpr double kSameDuration = 1e-2;

}  // namespace

FreshPlans::FreshPlans(const Systems& systems, const ClearanceProof& proof, const Itinerary& start,
                       const JointStates& goal, const PlanRules& rules, Random& random, const Budget& budget)
    : systems_(systems),
      start_(start),
      goals_(goal),
      lower_bound_(rules.lower_bound),
      random_(random),
      budget_(budget),
      alignment_(proof, rules, budget) {}

void FreshPlans::run(int evaluation_limit, double longest, const std::function<void(const Itinerary&)>& on_better) {
  const auto is_best = [this] { return !found_.empty() && found_.front().duration() <= lower_bound_; };
  while (evaluations() < evaluation_limit && !is_best() && !budget_.exhausted()) {
    ++drawn_;
    Itinerary drawn = start_;
    if (!draw_legs(drawn, 0) || !draw_legs(drawn, 1)) continue;
    const double busy = std::max(drawn.busy_time(0), drawn.busy_time(1));
    const double known = found_.empty() ? longest : std::min(longest, kTolerated * found_.front().duration());
    auto aligned = alignment_.shortest(drawn, random_.below(kArmCount), std::min(known, kFirstEnd * busy));
    if (!aligned) continue;
    const auto is_shorter = [](const Itinerary& left, const Itinerary& right) {
      return left.duration() < right.duration();
    };
    const auto place = std::upper_bound(found_.begin(), found_.end(), aligned->itinerary, is_shorter);
    const bool is_better = place == found_.begin();
    found_.insert(place, std::move(aligned->itinerary));
    if (is_better) on_better(found_.front());
  }
}

bool FreshPlans::draw_legs(Itinerary& itinerary, int arm) {
  const double kind = drawn_ == 1 ? 0.0 : random_.fraction();  // both straight at first
  const int vias = kind < kStraightShare ? 0 : kind < kStraightShare + kOneViaShare ? 1 : 2;
  JointState at = itinerary.start_state(arm);
  for (int via = 0; via <= vias; ++via) {
    if (budget_.exhausted()) return false;
    const JointState to = via < vias ? draw_via(arm) : goals_[arm];
    const auto motion = steer(*systems_[arm], at, to);
    if (!motion) return false;
    itinerary.append(arm, itinerary.arrival(arm), *motion, to);
    at = to;
  }
  return true;
}

JointState FreshPlans::draw_via(int arm) {
  const System& system = *systems_[arm];
  JointState state = {random_.in(system.range()), 0.0};
  if (!random_.chance(kRestShare)) state.velocity = random_.step() * velocity_scale(system);
  return state;
}

std::vector<Itinerary> FreshPlans::best(std::size_t count) const {
  std::vector<Itinerary> best;
  for (const Itinerary& itinerary : found_) {
    if (best.size() == count) break;
    if (best.empty() || itinerary.duration() > best.back().duration() * (1.0 + kSameDuration))
      best.push_back(itinerary);
  }
  return best;
}

}  // namespace dualarm

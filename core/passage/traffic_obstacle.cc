#include "core/passage/traffic_obstacle.h"

#include <algorithm>
#include <cmath>

#include "core/coordination/forbidden_set.h"
#include "core/coordination/upright.h"
#include "core/model/interval_set.h"

namespace dualarm {
namespace {

/// rad and s. How far inside of a slice the next one is cut, and how far inside of that one this has to be: ends of
/// slices are exact to less.
constexpr double kInside = 1e-6;
constexpr double kWithin = 1e-9;
/// Pairs of slices that are followed at most, and what they have to gain, s and rad.
constexpr int kMostSteps = 200;
constexpr double kProgress = 1e-4;

/// Of leaning bodies slices through positions may close small gaps; without them the set is smaller.
std::vector<Body> upright_bodies(std::vector<Body> bodies, const TrackedBody& object) {
  const bool leans = !upright(placed(object.body.shape, object.track->poses().front().pose));
  std::erase_if(bodies, [leans](const Body& body) { return leans || !upright(body.shape); });
  return bodies;
}

/// The interval that holds a value well inside.
template <class Intervals>
std::optional<Interval> around(double value, const Intervals& intervals) {
  for (const Interval& interval : intervals) {
    if (interval.lower + kWithin < value && value < interval.upper - kWithin) return interval;
  }
  return std::nullopt;
}

/// Just inside of an end of an interval; 0 is the beginning of time, and no end.
double inside_of_end(Interval interval, int direction) {
  const double end = direction < 0 ? interval.lower + kInside : interval.upper - kInside;
  return std::clamp(end, interval.lower, interval.upper);
}

}  // namespace

TrafficObstacle::TrafficObstacle(const Problem& problem, int arm, const TrackedBody& object, double clearance,
                                 const Budget& budget)
    : base_(problem.arms[arm].base),
      range_(problem.arms[arm].joint_range),
      clearance_(clearance),
      upright_(upright_bodies(moving_bodies(problem, arm), object)),
      object_(object),
      traffic_(base_, moving_bodies(problem, arm), {object}, clearance, budget) {}

std::optional<Interval> TrafficObstacle::times_around(const Meeting& meeting) const {
  return around(meeting.time, traffic_.times_at(meeting.position));
}

std::optional<Interval> TrafficObstacle::positions_around(const Meeting& meeting) const {
  const Shape there = placed(object_.body.shape, object_.track->pose_at(meeting.time));
  std::vector<Interval> all;
  for (const Body& body : upright_) {
    const IntervalSet of_body = blocked_positions(base_, body.shape, there, clearance_, range_);
    all.insert(all.end(), of_body.intervals().begin(), of_body.intervals().end());
  }
  return around(meeting.position, IntervalSet(std::move(all)).intervals());
}

Meeting TrafficObstacle::follow(Meeting from, int through_time, int through_positions,
                                const std::function<bool(const Meeting&)>& done) const {
  for (int step = 0; step < kMostSteps; ++step) {
    const Meeting before = from;
    const auto times = times_around(from);
    if (!times) return from;
    from.time = inside_of_end(*times, through_time);
    if (done(from) || !std::isfinite(from.time)) return from;
    const auto positions = positions_around(from);
    if (!positions) return from;
    from.position = inside_of_end(*positions, through_positions);
    const double moved = std::abs(from.time - before.time) + std::abs(from.position - before.position);
    if (done(from) || moved < kProgress) return from;
  }
  return from;
}

}  // namespace dualarm

#include "core/verification/clearance_check.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "core/verification/bounded_pairs.h"
#include "core/verification/sentence.h"
#include "core/verification/tolerances.h"

namespace dualarm {
namespace {

/// The smallest distance seen of a pair.
struct Sighting {
  double distance = std::numeric_limits<double>::infinity();
  double time = 0.0;
  Clearance clearance;
};

/// What is left to be looked at: a pair during an interval of time, with what is proven about it.
struct Candidate {
  std::size_t pair = 0;
  Interval time;
  double lower_bound = 0.0;
  double error = 0.0;         // of distances of the pair
  double distance = 0.0;      // seen in it, infinite if none was
  bool is_untouched = false;  // nobody has looked at the pair

  bool operator<(const Candidate& other) const { return lower_bound > other.lower_bound; }  // lowest bound on top
};

class ClearanceSearch {
 public:
  ClearanceSearch(const CarriedBodies& bodies, double duration, double demanded)
      : duration_(duration),
        demanded_(std::max(demanded, kTouching)),
        pairs_(pairs_that_may_meet(bodies, duration, demanded_)),
        sightings_(pairs_.size()) {
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      Candidate whole = {pair, pairs_[pair].time};
      const double swept = pairs_[pair].swept_distance;
      whole.lower_bound = swept >= demanded_ ? swept : -std::numeric_limits<double>::infinity();
      whole.is_untouched = true;
      candidates_.push(whole);
    }
  }

  /// Pairs that nobody has looked at keep what their boxes prove, or nothing if that is not enough.
  void run(const Budget& budget) {
    const std::size_t most_queries = kMostQueries + pairs_.size();
    while (!is_decided() && !budget.exhausted() && static_cast<std::size_t>(query_count_) < most_queries) {
      const Candidate candidate = candidates_.top();
      candidates_.pop();
      look_at(candidate.pair, candidate.time);
    }
  }

  ClearanceReport report() const {
    ClearanceReport report;
    const double proven = candidates_.empty() ? kept_ : std::min(kept_, candidates_.top().lower_bound);
    report.collision_free = proven >= demanded_;
    report.min_clearance = report.collision_free ? proven : query_count_ > 0 ? smallest_ : 0.0;
    report.distance_query_count = query_count_;
    const auto closest =
        std::min_element(sightings_.begin(), sightings_.end(),
                         [](const Sighting& left, const Sighting& right) { return left.distance < right.distance; });
    if (query_count_ > 0) report.closest = approach(static_cast<std::size_t>(closest - sightings_.begin()));
    if (report.collision_free) return report;
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      if (sightings_[pair].distance < demanded_) report.violations.push_back(collision(pair));
    }
    if (report.violations.empty()) report.violations.push_back(unknown(candidates_.top()));
    return report;
  }

 private:
  /// Keeps what a look proves to be good enough, and leaves what is before and after it.
  void look_at(std::size_t pair, Interval time) {
    const DistanceOverTime found(pairs_[pair].pair, time);
    const double middle = 0.5 * (time.lower + time.upper);
    take_sight(pair, middle, found.in_the_middle());
    const double enough = enough_distance(found.error());
    const Interval kept = found.keeps(enough);
    const bool is_cut = kept.length() == 0.0;
    const double cut = cut_of(pairs_[pair].pair, time);
    const Interval done = is_cut ? Interval{cut, cut} : kept;
    const auto leave = [&](Interval rest, double kept_time, double lower_bound) {
      if (lower_bound >= enough) {
        kept_ = std::min(kept_, lower_bound);
        return;
      }
      if (kept_time > 0.0) kept_ = std::min(kept_, enough);
      if (!is_cut && rest.length() == 0.0) return;
      const double seen =
          rest.contains(middle) ? found.in_the_middle().distance : std::numeric_limits<double>::infinity();
      candidates_.push({pair, rest, lower_bound, found.error(), seen});
    };
    leave({time.lower, done.lower}, middle - kept.lower, found.least_before());
    leave({done.upper, time.upper}, kept.upper - middle, found.least_after());
  }

  void take_sight(std::size_t pair, double time, const Clearance& seen) {
    ++query_count_;
    if (seen.distance < sightings_[pair].distance) sightings_[pair] = {seen.distance, time, seen};
    if (seen.distance < demanded_ && smallest_ >= demanded_) collision_seen_at_ = query_count_;
    smallest_ = std::min(smallest_, seen.distance);
  }

  /// m. From here on a lower bound is good enough, for distances with an error: as close to the smallest one seen as is
  /// told, and no collision unless one was seen.
  double enough_distance(double error) const {
    const double close = smallest_ - error - std::max(kClearanceResolution, kClearanceShare * (smallest_ - demanded_));
    return smallest_ < demanded_ ? close : std::max(close, demanded_);
  }

  /// The lowest bound decides: it is good enough, or nothing can make it better.
  bool is_decided() const {
    if (candidates_.empty()) return true;
    if (smallest_ < demanded_ && query_count_ >= collision_seen_at_ + kEvidenceQueries) return true;
    const Candidate& lowest = candidates_.top();
    if (lowest.is_untouched) return lowest.lower_bound >= smallest_;
    const bool is_final =
        lowest.time.length() <= kShortestInterval || lowest.lower_bound >= lowest.distance - lowest.error;
    return is_final || lowest.lower_bound >= enough_distance(lowest.error);
  }

  ClosestApproach approach(std::size_t pair) const {
    const Sighting& sighting = sightings_[pair];
    return {sighting.time, pairs_[pair].pair.first->body.name, pairs_[pair].pair.second->body.name,
            sighting.clearance.point_on_first, sighting.clearance.point_on_second};
  }

  Violation collision(std::size_t pair) const {
    const Sighting& sighting = sightings_[pair];
    return {ViolationKind::kClearance,
            sentence(pairs_[pair].pair.first->body.name, " and ", pairs_[pair].pair.second->body.name, " are ",
                     sighting.distance, " m apart at ", sighting.time, " s", afterwards(sighting.time), ", at (",
                     sighting.clearance.point_on_first.transpose(), ") and (",
                     sighting.clearance.point_on_second.transpose(), ") m; ", demanded_, " m are demanded"),
            "",
            sighting.time,
            sighting.distance,
            demanded_};
  }

  const char* afterwards(double time) const {
    return time > duration_ ? ", when the motion is over and the arm stands at its goal" : "";
  }

  Violation unknown(const Candidate& lowest) const {
    const BodyPair& pair = pairs_[lowest.pair].pair;
    const double middle = 0.5 * (lowest.time.lower + lowest.time.upper);
    return {
        ViolationKind::kClearanceUnknown,
        sentence("the clearance of ", pair.first->body.name, " and ", pair.second->body.name, " around ", middle, " s",
                 afterwards(middle), " is not proven after ", query_count_, " distance queries: seen ",
                 sightings_[lowest.pair].distance, " m, proven ", lowest.lower_bound, " m, demanded ", demanded_, " m"),
        "",
        middle,
        lowest.lower_bound,
        demanded_};
  }

  double duration_;  ///< s
  double demanded_;  ///< m
  std::vector<BoundedPair> pairs_;
  std::vector<Sighting> sightings_;
  std::priority_queue<Candidate> candidates_;
  double smallest_ = std::numeric_limits<double>::infinity();
  double kept_ = std::numeric_limits<double>::infinity();  ///< m, lowest bound of what needs no further look
  int query_count_ = 0;
  int collision_seen_at_ = 0;
};

}  // namespace

ClearanceReport check_clearance(const Problem& problem, const std::array<Interpolant, kArmCount>& motions,
                                double duration, const Budget& budget) {
  const CarriedBodies bodies = carried_bodies(problem, motions);
  ClearanceSearch search(bodies, duration, problem.options.clearance);
  search.run(budget);
  return search.report();
}

}  // namespace dualarm

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

/// A pair during an interval of time, with what is proven about it.
struct Candidate {
  std::size_t pair = 0;
  Interval time;
  double distance = std::numeric_limits<double>::infinity();  // in the middle; infinite while nobody has looked
  double error = 0.0;                                         // of that distance
  double lower_bound = 0.0;

  bool is_examined() const { return distance < std::numeric_limits<double>::infinity(); }

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
      candidates_.push(whole);
    }
  }

  /// Pairs that nobody has looked at keep what their boxes prove, or nothing if that is not enough.
  void run(const Budget& budget) {
    const std::size_t most_queries = kMostQueries + pairs_.size();
    while (!is_decided() && !budget.exhausted() && static_cast<std::size_t>(query_count_) < most_queries) {
      const Candidate candidate = candidates_.top();
      candidates_.pop();
      if (!candidate.is_examined()) {
        examine(candidate.pair, candidate.time);
        continue;
      }
      const double cut = cut_of(pairs_[candidate.pair].pair, candidate.time);
      examine(candidate.pair, {candidate.time.lower, cut});
      examine(candidate.pair, {cut, candidate.time.upper});
    }
  }

  ClearanceReport report() const {
    ClearanceReport report;
    const Candidate& lowest = candidates_.top();
    report.collision_free = lowest.lower_bound >= demanded_;
    report.min_clearance = report.collision_free ? lowest.lower_bound : query_count_ > 0 ? smallest_ : 0.0;
    report.distance_query_count = query_count_;
    const auto closest =
        std::min_element(sightings_.begin(), sightings_.end(),
                         [](const Sighting& left, const Sighting& right) { return left.distance < right.distance; });
    if (query_count_ > 0) report.closest = approach(static_cast<std::size_t>(closest - sightings_.begin()));
    if (report.collision_free) return report;
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      if (sightings_[pair].distance < demanded_) report.violations.push_back(collision(pair));
    }
    if (report.violations.empty()) report.violations.push_back(unknown(lowest));
    return report;
  }

 private:
  void examine(std::size_t pair, Interval time) {
    const DistanceOverTime found = distance_over(pairs_[pair].pair, time);
    const double distance = found.in_the_middle.distance;
    candidates_.push({pair, time, distance, found.error, found.lower_bound});
    ++query_count_;
    if (distance < sightings_[pair].distance) {
      sightings_[pair] = {distance, 0.5 * (time.lower + time.upper), found.in_the_middle};
    }
    if (distance < demanded_ && smallest_ >= demanded_) collision_seen_at_ = query_count_;
    smallest_ = std::min(smallest_, distance);
  }

  /// The lowest bound decides: it is good enough, or nothing can make it better.
  bool is_decided() const {
    if (smallest_ < demanded_ && query_count_ >= collision_seen_at_ + kEvidenceQueries) return true;
    const Candidate& lowest = candidates_.top();
    if (!lowest.is_examined()) return lowest.lower_bound >= smallest_;
    const double resolution = std::max(kClearanceResolution, kClearanceShare * (smallest_ - demanded_));
    const bool is_close = lowest.lower_bound >= smallest_ - lowest.error - resolution;
    const bool is_final =
        lowest.time.length() <= kShortestInterval || lowest.lower_bound >= lowest.distance - lowest.error;
    return is_final || (is_close && (lowest.lower_bound >= demanded_ || smallest_ < demanded_));
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
    return {ViolationKind::kClearanceUnknown,
            sentence("the clearance of ", pair.first->body.name, " and ", pair.second->body.name, " around ", middle,
                     " s", afterwards(middle), " is not proven after ", query_count_, " distance queries: seen ",
                     lowest.distance, " m, proven ", lowest.lower_bound, " m, demanded ", demanded_, " m"),
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

#pragma once

#include <vector>

#include "core/coordination/projection.h"
#include "core/coordination/ride.h"
#include "core/model/problem.h"

namespace dualarm {

/// The objects that move by themselves, as an arm meets them.
class Traffic final : public Meetings {
 public:
  /// Of an arm on `base` with `bodies`, in its link frame; `clearance` (m) is what they have to keep. A budget that is
  /// exhausted ends all answers early: whoever asks has to look at it before trusting one.
  Traffic(const Base& base, const std::vector<Body>& bodies, const std::vector<TrackedBody>& objects, double clearance,
          const Budget& budget);

  /// Times (s since the start of the plan, from 0 on) at which the arm, standing at a position (rad), is too close to
  /// an object. Exact for objects that do not turn; of others gaps may be missed during which they turn by less than
  /// kGap, or than kLeastGap where both are capsules.
  IntervalList times_at(double position) const override { return times(position, 0.0); }
  IntervalList times_over(Interval positions) const override {
    return times(0.5 * (positions.lower + positions.upper), 0.5 * positions.length());
  }

 private:
  struct ArmBody {
    Shape shape;         ///< in the link frame
    double reach = 0.0;  ///< m
  };
  /// A body that stands still for a while.
  struct Stop {
    Shape shape;
    Interval times;  ///< s
  };

  void add(const TrackedBody& object);
  IntervalList times(double position, double spread) const;

  Base base_;
  double clearance_;
  Budget budget_;
  double reach_ = 0.0;  ///< m, of all bodies of the arm
  std::vector<ArmBody> bodies_;
  std::vector<Stop> stops_;
  std::vector<RideTree> rides_;  ///< one an object
};

}  // namespace dualarm

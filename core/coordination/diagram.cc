#include "core/coordination/diagram.h"

#include <algorithm>

#include "core/coordination/projection.h"

namespace dualarm {
namespace {

/// Arm 2 on its own clock.
class OtherArm final : public Meetings {
 public:
  OtherArm(const ForbiddenSet& forbidden, const Profile& motion)
      : forbidden_(forbidden), motion_(motion), window_(motion.extent()) {}

  std::vector<Interval> times_at(double position) const override {
    return times_in(forbidden_.slice(position, window_));
  }
  std::vector<Interval> times_over(Interval positions) const override {
    return times_in(forbidden_.slice_over(positions, window_));
  }

 private:
  std::vector<Interval> times_in(const IntervalSet& positions) const {
    std::vector<Interval> times;
    for (const Interval& piece : positions.intervals()) {
      const IntervalSet of_piece = motion_.times_in(piece);
      times.insert(times.end(), of_piece.intervals().begin(), of_piece.intervals().end());
    }
    return times;
  }

  const ForbiddenSet& forbidden_;
  const Profile& motion_;
  Interval window_;
};

}  // namespace

std::optional<IntervalSet> forbidden_delays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second,
                                            const Budget& budget) {
  const Profile first_clock = first.asked_often();
  const Profile second_clock = second.asked_often();
  return project(OtherArm(forbidden, second_clock), first_clock, {std::max(first.duration(), second.duration())},
                 budget);
}

}  // namespace dualarm

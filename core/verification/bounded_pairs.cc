#include "core/verification/bounded_pairs.h"

#include <array>

#include "core/verification/swept_boxes.h"

namespace dualarm {
namespace {

/// Pairs of bodies from which on boxes over time cost less than the distance queries that they save.
constexpr std::size_t kManyPairs = 16;

/// Bodies over an interval of time that they have in common.
struct Group {
  const std::vector<CarriedBody>& bodies;
  std::vector<SweptBoxes> boxes;  ///< empty where pairs are few

  Group(const std::vector<CarriedBody>& all, Interval time, bool with_boxes) : bodies(all) {
    if (!with_boxes) return;
    boxes.reserve(all.size());
    for (const CarriedBody& body : all) boxes.emplace_back(body, time);
  }
};

/// All pairs of bodies of two kinds.
void add(std::vector<BoundedPair>& pairs, Group& firsts, Group& seconds, Interval time, double enough) {
  for (std::size_t i = 0; i < firsts.bodies.size(); ++i) {
    for (std::size_t j = 0; j < seconds.bodies.size(); ++j) {
      const bool is_boxed = !firsts.boxes.empty() && !seconds.boxes.empty();
      const double bound = is_boxed ? distance_of_boxes(firsts.boxes[i], seconds.boxes[j], enough) : 0.0;
      pairs.push_back({{&firsts.bodies[i], &seconds.bodies[j]}, time, bound});
    }
  }
}

/// What moves by itself after a time (s), against what has come to rest.
void add_afterwards(std::vector<BoundedPair>& pairs, const CarriedBodies& bodies, double duration, bool with_boxes,
                    double enough) {
  const Interval time = {duration, last_corner(bodies.tracked)};
  if (time.lower >= time.upper) return;
  Group tracked(bodies.tracked, time, with_boxes);
  for (const auto& arm : bodies.moving) {
    if (arm.empty() || !stands_after(arm.front(), duration)) continue;
    Group standing(arm, time, with_boxes);
    add(pairs, standing, tracked, time, enough);
  }
}

}  // namespace

std::vector<BoundedPair> pairs_that_may_meet(const CarriedBodies& bodies, double duration, double enough) {
  const std::size_t of_first = bodies.moving[0].size();
  const std::size_t of_second = bodies.moving[1].size();
  const std::size_t others = bodies.fixed.size() + bodies.tracked.size();
  const std::size_t count = of_first * of_second + (of_first + of_second) * others;
  const bool with_boxes = count >= kManyPairs;
  std::vector<BoundedPair> pairs;
  pairs.reserve(count);
  const Interval time = {0.0, duration};
  std::array<Group, kArmCount> moving = {Group(bodies.moving[0], time, with_boxes),
                                         Group(bodies.moving[1], time, with_boxes)};
  Group fixed(bodies.fixed, time, with_boxes);
  Group tracked(bodies.tracked, time, with_boxes);
  add(pairs, moving[0], moving[1], time, enough);
  for (Group& arm : moving) {
    add(pairs, arm, fixed, time, enough);
    add(pairs, arm, tracked, time, enough);
  }
  add_afterwards(pairs, bodies, duration, with_boxes, enough);
  return pairs;
}

}  // namespace dualarm

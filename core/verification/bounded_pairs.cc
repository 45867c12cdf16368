#include "core/verification/bounded_pairs.h"

#include <array>

#include "core/verification/swept_boxes.h"

namespace dualarm {
namespace {

/// Pairs of bodies from which on boxes over time cost less than the distance queries that they save.
constexpr std::size_t kManyPairs = 16;

using Boxes = std::vector<SweptBoxes>;

Boxes boxes_of(const std::vector<CarriedBody>& bodies, double duration) {
  Boxes boxes;
  boxes.reserve(bodies.size());
  for (const CarriedBody& body : bodies) boxes.emplace_back(body, Interval{0.0, duration});
  return boxes;
}

void add_bounded(std::vector<BoundedPair>& pairs, Boxes& firsts, Boxes& seconds, double enough) {
  for (SweptBoxes& first : firsts) {
    for (SweptBoxes& second : seconds) {
      pairs.push_back({{&first.body(), &second.body()}, distance_of_boxes(first, second, enough)});
    }
  }
}

void add(std::vector<BoundedPair>& pairs, const std::vector<CarriedBody>& firsts,
         const std::vector<CarriedBody>& seconds) {
  for (const CarriedBody& first : firsts) {
    for (const CarriedBody& second : seconds) pairs.push_back({{&first, &second}, 0.0});
  }
}

}  // namespace

std::vector<BoundedPair> pairs_that_may_meet(const CarriedBodies& bodies, double duration, double enough) {
  const std::size_t of_first = bodies.moving[0].size();
  const std::size_t of_second = bodies.moving[1].size();
  const std::size_t others = bodies.fixed.size() + bodies.tracked.size();
  const std::size_t count = of_first * of_second + (of_first + of_second) * others;
  std::vector<BoundedPair> pairs;
  pairs.reserve(count);
  if (count < kManyPairs) {
    add(pairs, bodies.moving[0], bodies.moving[1]);
    for (const auto& arm : bodies.moving) {
      add(pairs, arm, bodies.fixed);
      add(pairs, arm, bodies.tracked);
    }
    return pairs;
  }
  std::array<Boxes, kArmCount> moving = {boxes_of(bodies.moving[0], duration), boxes_of(bodies.moving[1], duration)};
  Boxes fixed = boxes_of(bodies.fixed, duration);
  Boxes tracked = boxes_of(bodies.tracked, duration);
  add_bounded(pairs, moving[0], moving[1], enough);
  for (Boxes& arm : moving) {
    add_bounded(pairs, arm, fixed, enough);
    add_bounded(pairs, arm, tracked, enough);
  }
  return pairs;
}

}  // namespace dualarm

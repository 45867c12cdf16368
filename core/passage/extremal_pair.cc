#include "core/passage/extremal_pair.h"

#include <algorithm>

namespace dualarm {
namespace {

/// Part of a plan's duration by which times that are meant to be one may differ by rounding. A gate that is passed in
/// turn but for this is one that asks for no more: it is left out of a largest bound, which stays a bound without it.
constexpr double kTimeRounding = 1e-12;

}  // namespace

std::optional<ExtremalPair> extremal_pair(const Travellers& travellers, const Gate& gate, const GateBound& bound,
                                          double duration) {
  const int early_arm = bound.early_arm;
  const Through early(travellers[early_arm], position_of(gate, early_arm), Hurry::kEarlyArrival);
  const Through late(travellers[1 - early_arm], position_of(gate, 1 - early_arm), Hurry::kLateDeparture);
  if (!early.exists() || !late.exists()) return std::nullopt;
  const bool is_known = duration == bound.duration;
  auto one = early.motion(is_known ? bound.early : early.within(duration));
  auto other = late.motion(is_known ? bound.late : late.within(duration));
  if (!one || !other) return std::nullopt;
  return ExtremalPair{early_arm, *std::move(one), *std::move(other), duration};
}

bool passes_in_turn(const ExtremalPair& pair, const Travellers& travellers, const Gate& gate) {
  const auto motion_of = [&](int arm) -> const Profile& { return arm == pair.early_arm ? pair.early : pair.late; };
  const auto start_of = [&](int arm) { return arm == pair.early_arm ? 0.0 : pair.wait(); };
  const Orders orders = orders_of(travellers, gate);
  const auto keeps = [&](const Order& order) {
    const int late_arm = 1 - order.early_arm;
    const auto arrival = passing_of(motion_of(order.early_arm), order.early_at, Hurry::kEarlyArrival);
    const auto departure = passing_of(motion_of(late_arm), order.late_at, Hurry::kLateDeparture);
    return arrival && departure &&
           start_of(order.early_arm) + arrival->before <=
               start_of(late_arm) + departure->before + kTimeRounding * pair.duration;
  };
  return orders.count > 0 && std::all_of(orders.orders.begin(), orders.orders.begin() + orders.count, keeps);
}

}  // namespace dualarm

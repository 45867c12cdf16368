#pragma once

#include <chrono>
#include <optional>
#include <variant>

#include "core/model/problem.h"
#include "core/model/trajectory.h"
#include "server/request/request_limits.h"
#include "server/request/violations.h"
#include "server/wire.h"

namespace dualarm {

/// What a request asks, or everything that is wrong with it.
template <typename Wish>
using Parsed = std::variant<Wish, Violations>;

struct PlanWish {
  Problem problem;
  std::optional<std::chrono::nanoseconds> budget;
  bool validate_only = false;
};

struct VerifyWish {
  Problem problem;
  Trajectory trajectory;
  bool check_end_states = false;
};

struct RegionWish {
  Problem problem;
  int resolution = 0;
};

struct PortraitWish {
  Problem problem;
  int arm = 0;
  int resolution = 0;
};

Parsed<PlanWish> parse(const wire::PlanMotionRequest& message, const RequestLimits& limits = kDefaultLimits);
Parsed<VerifyWish> parse(const wire::VerifyMotionRequest& message, const RequestLimits& limits = kDefaultLimits);
Parsed<RegionWish> parse(const wire::GetForbiddenRegionRequest& message, const RequestLimits& limits = kDefaultLimits);
Parsed<PortraitWish> parse(const wire::GetPhasePortraitRequest& message, const RequestLimits& limits = kDefaultLimits);

}  // namespace dualarm

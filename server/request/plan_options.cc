#include "server/request/plan_options.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dualarm {
namespace {

using google::protobuf::util::TimeUtil;

std::optional<Method> read_method(int number, std::string_view name, const Field& options) {
  switch (number) {
    case wire::METHOD_SIMULTANEOUS:
      return Method::kSimultaneous;
    case wire::METHOD_DELAY:
      return Method::kDelay;
    case wire::METHOD_STATE_TIME:
      return Method::kStateTime;
    case wire::METHOD_PASSAGE:
      return Method::kPassage;
    default:
      options.complain(name, fmt::format("is {}, must be METHOD_SIMULTANEOUS, METHOD_DELAY, METHOD_PASSAGE or "
                                         "METHOD_STATE_TIME",
                                         number));
      return std::nullopt;
  }
}

std::vector<Method> read_methods(const wire::PlanOptions& message, const Field& options) {
  std::vector<Method> methods;
  if (message.methods_size() > ranges::kMostListed) {
    options.complain("methods",
                     fmt::format("has {} entries, must name each method at most once", message.methods_size()));
    return methods;
  }
  for (int i = 0; i < message.methods_size(); ++i) {
    const std::string name = fmt::format("methods[{}]", i);
    const std::optional<Method> method = read_method(message.methods(i), name, options);
    if (!method) continue;
    if (std::find(methods.begin(), methods.end(), *method) != methods.end()) {
      options.complain(name, fmt::format("is {}, which is listed already: name each method once",
                                         wire::Method_Name(message.methods(i))));
    }
    methods.push_back(*method);
  }
  return methods;
}

bool is_close(double value, double expected) { return std::abs(value - expected) <= ranges::kPlaneTolerance; }

bool is_paper_mounting(const std::array<Arm, kArmCount>& arms) {
  const Base& first = arms[0].base;
  const Base& second = arms[1].base;
  return is_close(first.heading, 0.0) && first.rotation == Rotation::kCounterclockwise &&
         is_close(second.heading, std::numbers::pi) && second.rotation == Rotation::kClockwise &&
         second.position.x() > first.position.x() && is_close(first.position.y(), second.position.y()) &&
         is_close(first.position.z(), second.position.z());
}

}  // namespace

RegionModel read_region_model(wire::RegionModel model, const Field& field, const std::array<Arm, kArmCount>& arms) {
  switch (model) {
    case wire::REGION_MODEL_UNSPECIFIED:
    case wire::REGION_MODEL_EXACT:
      return RegionModel::kExact;
    case wire::REGION_MODEL_PAPER:
      if (!is_paper_mounting(arms)) {
        field.complain(
            "region_model",
            "is REGION_MODEL_PAPER, which needs the paper's mounting (arm 1 heading 0 counterclockwise, arm 2 "
            "heading pi clockwise, to the right of arm 1 at equal y and z): use REGION_MODEL_EXACT");
      }
      return RegionModel::kPaper;
    default:
      field.complain("region_model",
                     fmt::format("is {}, must be REGION_MODEL_EXACT or REGION_MODEL_PAPER", static_cast<int>(model)));
      return RegionModel::kExact;
  }
}

std::optional<std::chrono::nanoseconds> read_planning_budget(const wire::PlanOptions& message, const Field& options) {
  if (!message.has_planning_budget()) return std::nullopt;
  const auto& budget = message.planning_budget();
  constexpr std::int64_t kLongest = 1'000'000'000;  // s: more does not fit into 64 bits of nanoseconds
  constexpr std::int32_t kNanosPerSecond = 1'000'000'000;
  const bool positive = budget.seconds() >= 0 && budget.nanos() >= 0 && (budget.seconds() > 0 || budget.nanos() > 0);
  if (!positive || budget.seconds() > kLongest || budget.nanos() >= kNanosPerSecond) {
    options.complain("planning_budget", fmt::format("is {} s and {} ns, must be above 0 and at most {} s",
                                                    budget.seconds(), budget.nanos(), kLongest));
    return std::nullopt;
  }
  return std::chrono::nanoseconds(TimeUtil::DurationToNanoseconds(budget));
}

PlanOptions read_plan_options(const wire::PlanOptions& message, const Field& options) {
  PlanOptions read;
  read.clearance = options.number("clearance_m", message.clearance_m(), ranges::kSize);
  read.seed = message.seed();
  read.methods = read_methods(message, options);
  read.knot_period = message.knot_period_s() == 0.0
                         ? ranges::kDefaultKnotPeriod
                         : options.number("knot_period_s", message.knot_period_s(), ranges::kKnotPeriod);
  if (message.has_max_start_delay_s()) {
    read.max_start_delay = options.number("max_start_delay_s", message.max_start_delay_s(), ranges::kStartDelay);
  }
  return read;
}

}  // namespace dualarm

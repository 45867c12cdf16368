#include "tests/reference/random_drive.h"

#include <random>

#include "tests/reference/own_integration.h"

namespace dualarm {
namespace {

constexpr double kHair = 1e-6;          // share of a limit that is left unused
constexpr double kIntegration = 1e-13;  // rad and rad/s, of a step
constexpr int kStepsPerArc = 24;        // beyond which a limit is not broken
constexpr int kLooksPerStep = 16;       // at which the limits are looked at, besides the integration's own steps
constexpr double kLongestArc = 1.5;     // s

bool inside(const Arm& arm, const OwnState<double>& state) {
  const double margin = kHair * arm.joint_range.length();
  return state[0] >= arm.joint_range.lower + margin && state[0] <= arm.joint_range.upper - margin &&
         state[1] >= arm.velocity.lower * (1.0 - kHair) && state[1] <= arm.velocity.upper * (1.0 - kHair);
}

bool can_cruise(const Arm& arm, const OwnState<double>& state) {
  const OwnEquation<double> own(arm);
  const auto [lowest, highest] = own.torques(state[0], state[1]);
  const double needed = own.holding_torque(state[0], state[1]);
  const double margin = kHair * (highest - lowest);
  return needed >= lowest + margin && needed <= highest - margin;
}

}  // namespace

Drive drive_at_random(const Arm& arm, JointState start, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11U) * 0x1.0p-53; };
  OwnState<double> state = {start.position, start.velocity};
  double duration = 0.0;
  const int arcs = 1 + static_cast<int>(4.0 * uniform());
  for (int arc = 0; arc < arcs; ++arc) {
    const double kind = uniform();
    const bool cruises = kind > 0.9;
    const double share = kind < 0.4 ? 1.0 - kHair : kind < 0.8 ? kHair : uniform();
    const double step = kLongestArc * uniform() / kStepsPerArc;
    for (int i = 0; i < kStepsPerArc; ++i) {
      OwnState<double> next = {state[0] + step * state[1], state[1]};
      bool kept = true;
      const auto look = [&](const OwnState<double>& at, double) { kept = kept && inside(arm, at); };
      if (cruises) {
        kept = can_cruise(arm, state) && can_cruise(arm, next) && inside(arm, next);
      } else {
        next = state;
        for (int j = 0; j < kLooksPerStep; ++j) {
          next = OwnIntegration<double>(arm, share, kIntegration).run(next, step / kLooksPerStep, look);
        }
      }
      if (!kept) break;
      state = next;
      duration += step;
    }
  }
  return {{state[0], state[1]}, duration};
}

}  // namespace dualarm

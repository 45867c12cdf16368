#include "tests/core/passage/scene_travellers.h"

#include "core/phase_plane/time_optimal.h"

namespace dualarm {
namespace {

Traveller traveller(const SingleJointArm& system, const Task& task) {
  const auto motion = fastest_motion(system, task.start, task.goal);
  return {&system, task.start, task.goal, std::get<FastestMotion>(motion).profile};
}

}  // namespace

SceneTravellers::SceneTravellers(const Problem& problem)
    : systems{SingleJointArm(loaded_arm(problem, 0)), SingleJointArm(loaded_arm(problem, 1))},
      travellers{traveller(systems[0], problem.tasks[0]), traveller(systems[1], problem.tasks[1])} {}

}  // namespace dualarm

#include "tests/core/systems/limited_arms.h"

#include <random>

#include "core/systems/single_joint_arm.h"
#include "tests/core/phase_plane/test_arms.h"

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Builds one family.
class Family {
 public:
  explicit Family(std::string name) { family_.name = std::move(name); }

  /// An arm of inertia 2 kg m2 that turns from -4 to 5 rad, changed as asked.
  template <class Change>
  Family& with(std::string name, const TorqueLimit& torque, const Change& change) {
    Arm arm = pendulum(2.0, 3.0, 1.0);
    arm.joint_range = {-4.0, 5.0};
    arm.velocity = {-3.0, 4.0};
    arm.torque = torque;
    change(arm);
    family_.systems.emplace_back(std::move(name), std::make_shared<SingleJointArm>(arm));
    return *this;
  }

  Family& with(std::string name, const TorqueLimit& torque) {
    return with(std::move(name), torque, [](Arm& /*arm*/) {});
  }

  SystemFamily take() { return std::move(family_); }

 private:
  SystemFamily family_;
};

void weightless(Arm& arm) { arm.gravity.amplitude = 0.0; }
void upside_down(Arm& arm) { arm.gravity = {-3.0, 2.0}; }
void without_velocity_limit(Arm& arm) { arm.velocity = {-kInfinity, kInfinity}; }
void rubbing(Arm& arm) { arm.viscous_friction = 0.7; }
void rubbing_without_velocity_limit(Arm& arm) {
  rubbing(arm);
  arm.velocity = {-kInfinity, 2.0};
}

SystemFamily constant_limits() {
  return Family("ConstantLimits")
      .with("strong", Interval{-6.0, 6.0})
      .with("asymmetric", Interval{-9.0, 4.0})
      .with("weak", Interval{-1.5, 1.9})
      .with("one sided", Interval{0.4, 2.0})
      .with("upside down", Interval{-5.0, 2.5}, upside_down)
      .with("weightless", Interval{-1.0, 3.0}, weightless)
      .with("as the paper's", Interval{-60.0, 60.0}, [](Arm& arm) { arm = pendulum(39.0, 29.43, 60.0); })
      .take();
}

SystemFamily constant_limits_with_friction() {
  return Family("ConstantLimitsWithFriction")
      .with("strong", Interval{-6.0, 6.0}, rubbing)
      .with("weak", Interval{-1.5, 1.9}, rubbing)
      .with("fast", Interval{-1.5, 4.0}, rubbing_without_velocity_limit)
      .take();
}

SystemFamily torque_speed_lines() {
  return Family("TorqueSpeedLines")
      .with("strong", TorqueSpeedLine{5.0, 6.0})
      .with("slow", TorqueSpeedLine{5.0, 2.5})
      .with("weak", TorqueSpeedLine{2.0, 3.0}, upside_down)
      .with("weightless", TorqueSpeedLine{2.0, 3.0}, weightless)
      .with("fast", TorqueSpeedLine{2.0, 3.0}, without_velocity_limit)
      .take();
}

SystemFamily torque_speed_lines_with_friction() {
  return Family("TorqueSpeedLinesWithFriction")
      .with("strong", TorqueSpeedLine{5.0, 6.0}, rubbing)
      .with("weak", TorqueSpeedLine{2.0, 2.5}, rubbing)
      .with("fast", TorqueSpeedLine{2.0, 3.0}, rubbing_without_velocity_limit)
      .take();
}

const TorqueTable kOverPositions = {
    {-3.0, -1.0, 0.5, 2.0, 6.0}, {0.0}, {{-4.0, 2.0}, {-2.0, 5.0}, {-6.0, 1.0}, {-1.0, 0.5}, {-3.0, 4.0}}};
const TorqueTable kOverVelocities = {
    {0.3}, {-5.0, -1.0, 2.0, 3.5}, {{-0.5, 4.0}, {-3.0, 4.0}, {-4.0, 3.0}, {-4.0, 1.0}}};

SystemFamily tables_over_positions() {
  return Family("TablesOverPositions")
      .with("heavy", kOverPositions)
      .with("weightless", kOverPositions, weightless)
      .with("upside down", kOverPositions, upside_down)
      .with("rubbing", kOverPositions, rubbing)
      .with("two rows", TorqueTable{{-1.0, 1.0}, {2.0}, {{-4.0, -1.0}, {1.0, 4.0}}})
      // Standing at -1 rad the arm is held by exactly its strongest torque, on a bend.
      .with("zero on a bend", TorqueTable{{-2.0, -1.0, 1.0}, {0.0}, {{-9.0, 1.0}, {-8.0, 0.0}, {-8.0, -2.0}}},
            weightless)
      .with("one entry", TorqueTable{{0.4}, {1.0}, {{-2.0, 2.5}}})
      .take();
}

SystemFamily tables_over_velocities() {
  return Family("TablesOverVelocities")
      .with("heavy", kOverVelocities)
      .with("fast", kOverVelocities, without_velocity_limit)
      .with("rubbing", kOverVelocities, rubbing)
      .with("fast and rubbing", kOverVelocities, rubbing_without_velocity_limit)
      // Independent of the velocity where the joint falls; stronger in motion where it rises.
      .with("stronger in motion", TorqueTable{{0.0}, {-2.0, 0.0, 1.0}, {{-3.0, 2.0}, {-3.0, 2.0}, {-4.0, 2.5}}})
      // The same, but for friction that takes more than motion gives.
      .with("stronger in motion, rubbing",
            TorqueTable{{0.0}, {-2.0, 0.0, 1.0}, {{-3.0, 2.0}, {-3.0, 2.0}, {-4.0, 2.5}}}, rubbing)
      // All columns lie on one side: interpolation from the nearest reaches across standstill.
      .with("columns of falling only", TorqueTable{{0.0}, {-2.0, -1.0}, {{-3.0, 2.0}, {-4.0, 2.5}}})
      .with("columns of rising only", TorqueTable{{0.0}, {1.0, 2.0}, {{-3.0, 2.0}, {-4.0, 2.5}}})
      .with("columns astride", TorqueTable{{0.0}, {-1.0, 2.0}, {{-3.0, 2.0}, {-4.0, 2.0}}})
      .with("one column", TorqueTable{{-1.0, 2.0}, {-1.0}, {{-3.0, 2.0}, {-4.0, 2.5}}})
      .take();
}

/// Tables of many shapes, some weak, some far outside the range; fixed seeds, which are their names.
SystemFamily random_tables() {
  Family family("RandomTables");
  for (unsigned seed = 1; seed <= 16; ++seed) {
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto grid = [&](double at, double step) {
      std::vector<double> values = {at};
      for (int count = static_cast<int>(draw(0.0, 7.0)); count > 0; --count) {
        values.push_back(values.back() + draw(0.2, step));
      }
      return values;
    };
    TorqueTable table = {grid(draw(-6.0, 3.0), 3.0), grid(draw(-4.0, 1.0), 2.0), {}};
    while (table.limits.size() < table.positions.size() * table.velocities.size()) {
      const double middle = draw(-2.0, 2.0);
      const double half = draw(0.5, 6.0);
      table.limits.push_back({middle - half, middle + half});
    }
    family.with(std::to_string(seed), table, [&](Arm& arm) {
      arm.gravity = {draw(-4.0, 4.0), draw(-3.0, 3.0)};
      if (seed % 2 == 0) arm.viscous_friction = draw(0.1, 2.0);
      if (seed % 3 == 0) without_velocity_limit(arm);
    });
  }
  return family.take();
}

}  // namespace

std::vector<SystemFamily> arms_with_every_limit() {
  return {constant_limits(),       constant_limits_with_friction(),
          torque_speed_lines(),    torque_speed_lines_with_friction(),
          tables_over_positions(), tables_over_velocities(),
          random_tables()};
}

}  // namespace dualarm

#include "tests/reference/energy_sweep.h"

#include <numbers>
#include <vector>

namespace dualarm {
namespace {

/// Cells above which the energies of a mesh are right to rounding, so that only its times have an error.
constexpr std::size_t kFine = 500;

/// The arm seen along a motion from `from` in a direction: x >= 0 is the distance travelled, w >= 0 the speed.
class Sweep {
 public:
  Sweep(const Arm& arm, JointState from, JointState to, int cells)
      : own_(arm), from_(from.position), direction_(to.position < from.position ? -1 : 1) {
    const double length = std::abs(to.position - from.position);
    for (int i = 0; i <= cells; ++i) mesh_.push_back(0.5 * length * (1.0 - std::cos(std::numbers::pi * i / cells)));
    const double fastest = direction_ > 0 ? arm.velocity.upper : -arm.velocity.lower;
    limit_ = 0.5 * fastest * fastest;
    start_ = 0.5 * from.velocity * from.velocity;
    end_ = 0.5 * to.velocity * to.velocity;
  }

  std::optional<double> time() {
    const std::size_t last = mesh_.size() - 1;
    std::vector<double> ceiling(mesh_.size(), std::min(end_, limit_));
    for (std::size_t i = last; i > 0; --i) {
      ceiling[i - 1] = std::min(limit_, step(-1, mesh_[i], mesh_[i - 1], ceiling[i]));
      if (ceiling[i - 1] < 0.0) return std::nullopt;
    }
    if (start_ > ceiling[0] || end_ > limit_) return std::nullopt;
    double energy = start_;
    double time = 0.0;
    for (std::size_t i = 0; i < last; ++i) {
      const double next = std::min(ceiling[i + 1], step(+1, mesh_[i], mesh_[i + 1], energy));
      if (next < 0.0 || energy + next <= 0.0) return std::nullopt;
      time += 2.0 * (mesh_[i + 1] - mesh_[i]) / (std::sqrt(2.0 * energy) + std::sqrt(2.0 * next));
      energy = next;
    }
    // Drive that falls short of the velocity at the end: the mesh has no such motion.
    constexpr double kShort = 1e-9;  // of the energy
    if (energy < end_ * (1.0 - kShort)) return std::nullopt;
    return time;
  }

 private:
  double gain(int sense, double x, double energy) const {
    const double speed = std::sqrt(2.0 * std::max(0.0, energy));
    return direction_ * own_.acceleration(sense * direction_, from_ + direction_ * x, direction_ * speed);
  }

  /// Energy at `to` on the arc of full drive (sense > 0) or full braking through `energy` at `from`. On fine meshes
  /// halved until it no longer changes: bends of the limits would cost it its digits.
  double step(int sense, double from, double to, double energy) const {
    const double whole = single_step(sense, from, to, energy);
    return mesh_.size() > kFine ? refined(sense, from, to, energy, whole, 0) : whole;
  }

  double refined(int sense, double from, double to, double energy, double whole, int depth) const {
    constexpr double kUnchanged = 1e-13;  // (rad/s)2
    constexpr int kDeepest = 12;
    const double middle = 0.5 * (from + to);
    const double half = single_step(sense, from, middle, energy);
    const double halves = single_step(sense, middle, to, half);
    if (depth == kDeepest || std::abs(halves - whole) <= kUnchanged * std::max(1.0, energy)) return halves;
    const double there = refined(sense, from, middle, energy, half, depth + 1);
    return refined(sense, middle, to, there, single_step(sense, middle, to, there), depth + 1);
  }

  /// Runge-Kutta 4.
  double single_step(int sense, double from, double to, double energy) const {
    const double h = to - from;
    const double middle = 0.5 * (from + to);
    const double k1 = gain(sense, from, energy);
    const double k2 = gain(sense, middle, energy + 0.5 * h * k1);
    const double k3 = gain(sense, middle, energy + 0.5 * h * k2);
    const double k4 = gain(sense, to, energy + h * k3);
    return energy + h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
  }

  OwnEquation<double> own_;
  double from_;
  int direction_;
  std::vector<double> mesh_;
  double limit_ = 0.0;
  double start_ = 0.0;
  double end_ = 0.0;
};

}  // namespace

std::optional<double> sweep_time(const Arm& arm, JointState from, JointState to, int cells) {
  if (from.position == to.position) {
    return from.velocity == to.velocity ? std::optional<double>(0.0) : std::nullopt;
  }
  const double direction = to.position < from.position ? -1.0 : 1.0;
  if (direction * from.velocity < 0.0 || direction * to.velocity < 0.0) return std::nullopt;
  return Sweep(arm, from, to, cells).time();
}

std::optional<Stop> full_stop(const Arm& arm, JointState state, bool backwards) {
  if (state.velocity == 0.0) return std::nullopt;
  const OwnEquation<double> own(arm);
  const int sense = (state.velocity > 0.0) == backwards ? 1 : -1;
  constexpr double kLongest = 20.0;  // s
  constexpr double kStep = 2e-3;     // s; the order of the steps leaves 1e-12
  const double sign = backwards ? -1.0 : 1.0;
  double x = state.position;
  double w = state.velocity;
  // One step of Runge-Kutta 4 from (x, w).
  const auto stepped = [&](double h) {
    const double a1 = own.acceleration(sense, x, w);
    const double v2 = w + 0.5 * h * a1;
    const double a2 = own.acceleration(sense, x + 0.5 * h * w, v2);
    const double v3 = w + 0.5 * h * a2;
    const double a3 = own.acceleration(sense, x + 0.5 * h * v2, v3);
    const double v4 = w + h * a3;
    const double a4 = own.acceleration(sense, x + h * v3, v4);
    return JointState{x + h * (w + 2.0 * v2 + 2.0 * v3 + v4) / 6.0, w + h * (a1 + 2.0 * a2 + 2.0 * a3 + a4) / 6.0};
  };
  const auto stopped = [&](double velocity) { return velocity * state.velocity <= 0.0; };
  for (double time = 0.0; time < kLongest; time += kStep) {
    const JointState next = stepped(sign * kStep);
    if (stopped(next.velocity)) {
      double low = 0.0;
      double high = kStep;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (stopped(stepped(sign * middle).velocity) ? high : low) = middle;
      }
      const double position = stepped(sign * high).position;
      if (!arm.joint_range.contains(position)) return std::nullopt;
      return Stop{position, time + high};
    }
    if (!arm.joint_range.contains(next.position) || !arm.velocity.contains(next.velocity)) return std::nullopt;
    x = next.position;
    w = next.velocity;
  }
  return std::nullopt;
}

}  // namespace dualarm

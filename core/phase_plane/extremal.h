#pragma once

#include <optional>
#include <vector>

#include "core/phase_plane/path.h"
#include "core/phase_plane/trace.h"

namespace dualarm {

/// The curve in the phase plane of full driving or full braking through a state, followed to one side until something
/// stops it: by work and energy where the velocity does not matter, else integrated. Refers to its Path.
/// Theory, section 1.1.
class Extremal {
 public:
  /// Why it ends.
  enum class Exit {
    kArrived,  ///< at the x asked for
    kLimit,    ///< at the velocity limit
    kRest,     ///< at rest before the x asked for
  };

  /// Through `energy` (at most the limit's) at x = `anchor`, followed to `until` on either side.
  Extremal(const Path& path, ArcKind kind, double anchor, double energy, double until);

  ArcKind kind() const { return kind_; }
  double end() const { return end_; }  ///< x where it ends
  Exit exit() const { return exit_; }

  /// Energy at an x between the anchor and the end; not negative.
  double energy_at(double x) const;

  /// Points between `from` and `to` (ascending, on the curve), ascending, at which the energy is known without work.
  std::vector<double> nodes(double from, double to) const;

  /// Where between `from` and `to` (ascending, on the curve) the energy is largest, of an arc of work and energy.
  double fastest_between(double from, double to) const;

  /// Where between `from` and `to` (ascending, on the curve) the accelerations along it have a bend, ends excluded.
  std::vector<double> bends(double from, double to) const;

 private:
  void follow_work(double until);
  void follow_trace(double until);
  std::vector<double> traced(double from, double to, bool only_bends) const;
  double work_energy(double x) const { return anchor_energy_ + path_->work(kind_, anchor_, x - anchor_); }

  const Path* path_;
  ArcKind kind_;
  double anchor_;
  double anchor_energy_;
  double end_;
  Exit exit_ = Exit::kArrived;
  std::optional<Trace> trace_;
};

}  // namespace dualarm

#include "core/phase_plane/extremal.h"

#include <algorithm>

#include "core/phase_plane/crossing.h"

namespace dualarm {

Extremal::Extremal(const Path& path, ArcKind kind, double anchor, double energy, double until)
    : path_(&path), kind_(kind), anchor_(anchor), anchor_energy_(energy), end_(until) {
  if (path.velocity_matters(kind)) {
    follow_trace(until);
  } else {
    follow_work(until);
  }
}

/// Between sign changes of the acceleration the energy is monotone, so its value at their ends tells what happens.
void Extremal::follow_work(double until) {
  std::vector<double> cuts = path_->pieces(kind_, 0.0, std::min(anchor_, until), std::max(anchor_, until));
  if (until < anchor_) std::reverse(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double energy = work_energy(cuts[i + 1]);
    if (energy > path_->energy_limit()) {
      end_ = crossing([this](double x) { return work_energy(x) - path_->energy_limit(); }, cuts[i], cuts[i + 1]);
      exit_ = Exit::kLimit;
      return;
    }
    if (energy < 0.0 || (energy == 0.0 && cuts[i + 1] != until)) {
      end_ = crossing([this](double x) { return work_energy(x); }, cuts[i], cuts[i + 1]);
      exit_ = Exit::kRest;
      return;
    }
  }
}

void Extremal::follow_trace(double until) {
  const double time_sign = until > anchor_ ? 1.0 : -1.0;
  // From rest the acceleration has to lead away, or the arc ends where it begins.
  if (anchor_energy_ == 0.0 && time_sign * path_->acceleration(kind_, anchor_, 0.0) <= 0.0) {
    end_ = anchor_;
    exit_ = Exit::kRest;
    return;
  }
  const JointState from = {path_->position(anchor_), path_->velocity(anchor_energy_)};
  trace_.emplace(path_->system(), path_->extreme(kind_), from, time_sign, path_->position(until),
                 std::sqrt(2.0 * path_->energy_limit()));
  switch (trace_->stop()) {
    case Trace::Stop::kArrived:
      return;
    case Trace::Stop::kLimit:
      exit_ = Exit::kLimit;
      break;
    case Trace::Stop::kRest:
      exit_ = Exit::kRest;
      break;
  }
  end_ = path_->x(trace_->end().state.position);
}

double Extremal::energy_at(double x) const {
  if (!trace_) return std::max(0.0, work_energy(x));
  if (x == anchor_) return anchor_energy_;
  const double velocity = trace_->at_position(path_->position(x)).state.velocity;
  return std::min(0.5 * velocity * velocity, path_->energy_limit());
}

double Extremal::fastest_between(double from, double to) const {
  double fastest = from;
  for (const double x : path_->pieces(kind_, 0.0, from, to)) {
    if (energy_at(x) > energy_at(fastest)) fastest = x;
  }
  return fastest;
}

std::vector<double> Extremal::bends(double from, double to) const {
  return trace_ ? traced(from, to, true) : path_->bends(from, to);
}

std::vector<double> Extremal::nodes(double from, double to) const {
  return trace_ ? traced(from, to, false) : std::vector<double>{};
}

std::vector<double> Extremal::traced(double from, double to, bool only_bends) const {
  std::vector<double> found;
  for (const Trace::Node& node : trace_->nodes()) {
    const double x = path_->x(node.state.position);
    if ((node.at_bend || !only_bends) && from < x && x < to) found.push_back(x);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace dualarm

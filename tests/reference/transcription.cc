#include "tests/reference/transcription.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlopt.hpp>
#include <stdexcept>

#include "tests/reference/transcription_starts.h"

namespace dualarm {
namespace {

constexpr int kPerArm = 1 + 2 * kStretches;
constexpr int kVariables = 1 + kArmCount * kPerArm;
constexpr int kEquations = 2 * kArmCount;
constexpr double kDifference = 1e-6;  // s and shares, step of the derivatives
constexpr double kConverged = 1e-9;   // of the variables, a step that ends the search
constexpr double kTight = 1e-7;       // rad, rad/s, s, m: what the optimiser counts as kept

/// Variables: the duration, then each arm's wait, lengths and shares.
std::vector<double> variables_of(const Scripts& scripts) {
  std::vector<double> x = {std::max(scripts[0].duration(), scripts[1].duration())};
  for (const Script& script : scripts) {
    x.push_back(script.wait);
    for (const Stretch& stretch : script.stretches) x.push_back(stretch.duration);
    for (const Stretch& stretch : script.stretches) x.push_back(stretch.share);
  }
  return x;
}

Scripts scripts_of(const std::vector<double>& x) {
  Scripts scripts;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const double* own = &x[1 + arm * kPerArm];
    scripts[arm].wait = own[0];
    for (int i = 0; i < kStretches; ++i) scripts[arm].stretches.push_back({own[1 + i], own[1 + kStretches + i]});
  }
  return scripts;
}

/// The functions that NLopt asks for, with their derivatives by differences, one point at a time.
class Functions {
 public:
  explicit Functions(const Problem& problem)
      : problem_(problem), count_(rows(std::vector<double>(kVariables, 0.0)).size()) {}

  std::size_t count() const { return count_; }

  /// Equations first, then what must not be above zero. The derivative is row by row.
  const std::vector<double>& values(const std::vector<double>& x) {
    if (x != at_) {
      at_ = x;
      values_ = rows(x);
      slopes_.clear();
    }
    return values_;
  }
  const std::vector<double>& slopes(const std::vector<double>& x) {
    const std::vector<double> here = values(x);
    if (!slopes_.empty()) return slopes_;
    slopes_.resize(count_ * kVariables);
    for (int j = 0; j < kVariables; ++j) {
      std::vector<double> moved = x;
      const bool is_share = j > 0 && (j - 1) % kPerArm > kStretches;
      const double step = is_share && x[j] > 0.0 ? -kDifference : kDifference;
      moved[j] += step;
      const std::vector<double> there = rows(moved);
      for (std::size_t i = 0; i < count_; ++i) slopes_[i * kVariables + j] = (there[i] - here[i]) / step;
    }
    return slopes_;
  }

 private:
  std::vector<double> rows(const std::vector<double>& x) const {
    const Scripts scripts = scripts_of(x);
    const Rehearsal seen = rehearse(problem_, scripts, x[0]);
    std::vector<double> all;
    for (int arm = 0; arm < kArmCount; ++arm) {
      all.push_back(seen.position_miss[arm]);
      all.push_back(seen.velocity_miss[arm]);
    }
    for (int arm = 0; arm < kArmCount; ++arm) {
      all.push_back(scripts[arm].duration() - x[0]);
      all.push_back(problem_.arms[arm].joint_range.lower - seen.positions[arm].lower);
      all.push_back(seen.positions[arm].upper - problem_.arms[arm].joint_range.upper);
    }
    for (const double separation : seen.separations) all.push_back(problem_.options.clearance - separation);
    return all;
  }

  const Problem& problem_;
  std::size_t count_;
  std::vector<double> at_;
  std::vector<double> values_;
  std::vector<double> slopes_;
};

void copy_rows(Functions& functions, unsigned n, const double* x, std::ptrdiff_t first, unsigned count, double* result,
               double* gradient) {
  const std::vector<double> at(x, x + n);
  std::copy_n(functions.values(at).begin() + first, count, result);
  if (gradient != nullptr) std::copy_n(functions.slopes(at).begin() + first * kVariables, count * n, gradient);
}

void equations(unsigned count, double* result, unsigned n, const double* x, double* gradient, void* functions) {
  copy_rows(*static_cast<Functions*>(functions), n, x, 0, count, result, gradient);
}

void limits(unsigned count, double* result, unsigned n, const double* x, double* gradient, void* functions) {
  copy_rows(*static_cast<Functions*>(functions), n, x, kEquations, count, result, gradient);
}

double duration_of(unsigned n, const double* x, double* gradient, void*) {
  if (gradient != nullptr) {
    std::fill_n(gradient, n, 0.0);
    gradient[0] = 1.0;
  }
  return x[0];
}

std::vector<double> optimised(const Problem& problem, std::vector<double> x, int evaluations) {
  constexpr double kLongest = 3.0;  // of the start's duration
  Functions functions(problem);
  nlopt::opt optimiser(nlopt::LD_SLSQP, kVariables);
  std::vector<double> lower(kVariables, 0.0);
  std::vector<double> upper(kVariables, kLongest * x[0]);
  for (int j = 1; j < kVariables; ++j) {
    if ((j - 1) % kPerArm <= kStretches) continue;
    lower[j] = -1.0;
    upper[j] = 1.0;
  }
  optimiser.set_lower_bounds(lower);
  optimiser.set_upper_bounds(upper);
  optimiser.set_min_objective(duration_of, nullptr);
  optimiser.add_equality_mconstraint(equations, &functions, std::vector<double>(kEquations, kTight));
  optimiser.add_inequality_mconstraint(limits, &functions, std::vector<double>(functions.count() - kEquations, kTight));
  optimiser.set_maxeval(evaluations);
  optimiser.set_xtol_rel(kConverged);
  for (int j = 0; j < kVariables; ++j) x[j] = std::clamp(x[j], lower[j], upper[j]);
  double duration = 0.0;
  try {
    optimiser.optimize(x, duration);
  } catch (const std::runtime_error&) {  // out of digits or stuck: x is where it got to, and is judged as any other
  }
  return x;
}

/// A second time from where the first ends: the optimiser forgets what it took for the curvature on its way.
std::vector<double> optimised_twice(const Problem& problem, const Scripts& start, int evaluations) {
  constexpr double kHopeless = 0.05;  // rad, rad/s and m
  const std::vector<double> x = optimised(problem, variables_of(start), evaluations);
  const Rehearsal seen = rehearse(problem, scripts_of(x), x[0]);
  double miss = clearance_miss(problem, seen);
  for (int arm = 0; arm < kArmCount; ++arm) {
    miss = std::max({miss, std::abs(seen.position_miss[arm]), std::abs(seen.velocity_miss[arm])});
  }
  return miss < kHopeless ? optimised(problem, x, evaluations) : x;
}

Transcribed closely(const Problem& problem, const std::vector<double>& x) {
  constexpr Rehearsing kClose = {100, 400, 9, 0.3};  // ten times the steps and seventeen times the nodes of a search
  Transcribed result;
  result.scripts = scripts_of(x);
  result.duration = std::max(result.scripts[0].duration(), result.scripts[1].duration());
  result.close = rehearse(problem, result.scripts, result.duration, kClose);
  result.holds =
      clearance_miss(problem, result.close) <= kClearanceTolerance && result.close.torque_shortfall <= kTorqueTolerance;
  for (int arm = 0; arm < kArmCount; ++arm) {
    const Interval range = problem.arms[arm].joint_range;
    const Interval swept = result.close.positions[arm];
    result.holds = result.holds && std::abs(result.close.position_miss[arm]) <= kEndTolerance &&
                   std::abs(result.close.velocity_miss[arm]) <= kEndTolerance &&
                   swept.lower >= range.lower - kRangeTolerance && swept.upper <= range.upper + kRangeTolerance;
  }
  return result;
}

}  // namespace

Transcription transcribe(const Problem& problem, const TranscriptionEffort& effort) {
  Transcription result;
  for (int round = 0; round < effort.rounds; ++round) {
    for (const Scripts& start : transcription_starts(problem, effort.seed + round, effort.draws, effort.kinds)) {
      const Transcribed found = closely(problem, optimised_twice(problem, start, effort.evaluations));
      ++result.runs;
      result.held += found.holds ? 1 : 0;
      if (found.holds && (!result.best || found.duration < result.best->duration)) result.best = found;
    }
  }
  return result;
}

}  // namespace dualarm

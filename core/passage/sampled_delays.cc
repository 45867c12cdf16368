#include "core/passage/sampled_delays.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace dualarm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Samples of each leg, dense where it turns.
constexpr int kSamples = 24;
/// Bits and steps of the search between samples.
constexpr int kBits = 16;
constexpr std::uintmax_t kMostSteps = 14;
/// How far an end moves from one sample to the next, as a part of the longer duration.
constexpr double kNear = 0.1;
/// Delays (s) this close are one: rounding of the widening.
constexpr double kSameDelay = 1e-9;

double share_of(int i) { return 0.5 - 0.5 * std::cos(std::numbers::pi * i / kSamples); }

}  // namespace

SampledDelays::SampledDelays(const ForbiddenSet& forbidden, const Profile& first, const Profile& second, double closed)
    : forbidden_(&forbidden),
      first_(&first),
      second_(&second),
      extent_(second.extent()),
      longest_(std::max(first.duration(), second.duration())),
      closed_(closed * longest_) {
  samples_.reserve(2 + kSamples * first.legs().size());
  add(nullptr, first.start(), -kInfinity, 0.0);
  add(nullptr, first.goal(), first.duration(), kInfinity);
  for (const Leg& leg : first.legs()) {
    for (int i = 1; i < kSamples; ++i) {
      const double position = leg.start + (leg.goal - leg.start) * share_of(i);
      const double time = first.time_at(leg, position);
      add(&leg, position, time, time);
    }
  }
}

IntervalList SampledDelays::delays_at(double position, double earliest, double latest) const {
  IntervalList times;
  for (const Interval& piece : forbidden_->pieces(position, 0.0, extent_)) second_->add_times_in(piece, times);
  for (Interval& piece : times) piece = {earliest - piece.upper, latest - piece.lower};
  return times;
}

void SampledDelays::add(const Leg* leg, double position, double earliest, double latest) {
  for (const Interval& delays : delays_at(position, earliest, latest)) samples_.push_back({leg, position, delays});
}

IntervalSet SampledDelays::forbidden() const {
  std::vector<Interval> delays;
  delays.reserve(samples_.size());
  for (const Sample& sample : samples_) delays.push_back(sample.delays);
  return unite_across(std::move(delays), closed_);
}

void SampledDelays::sharpen_near(double delay) {
  std::vector<Sample> sharp;
  for (const Sample& sample : samples_) {
    if (sample.leg == nullptr) continue;
    for (const double sign : {1.0, -1.0}) {
      const double end = sign > 0.0 ? sample.delays.lower : sample.delays.upper;
      if (std::abs(end - delay) > kSameDelay) continue;
      Sample better = sample;
      (sign > 0.0 ? better.delays.lower : better.delays.upper) = sharpened(sample, sign);
      sharp.push_back(better);
    }
  }
  samples_.insert(samples_.end(), sharp.begin(), sharp.end());
}

/// The lower end (sign 1) or upper end (-1) of a sample's delays, at its worst between the neighbouring samples.
double SampledDelays::sharpened(const Sample& sample, double sign) const {
  const Leg& leg = *sample.leg;
  const double share = (sample.position - leg.start) / (leg.goal - leg.start);
  const double angle = std::acos(std::clamp(1.0 - 2.0 * share, -1.0, 1.0));
  const double step = std::numbers::pi / kSamples;
  const double known = sign > 0.0 ? sample.delays.lower : -sample.delays.upper;
  const auto end_at = [&](double at) {
    const double position = leg.start + (leg.goal - leg.start) * (0.5 - 0.5 * std::cos(at));
    const double time = first_->time_at(leg, position);
    double least = kInfinity;
    for (const Interval& delays : delays_at(position, time, time)) {
      const double end = sign > 0.0 ? delays.lower : -delays.upper;
      if (std::abs(end - known) < kNear * longest_) least = std::min(least, end);
    }
    return std::min(least, known + kNear * longest_);
  };
  std::uintmax_t steps = kMostSteps;
  const double found = boost::math::tools::brent_find_minima(end_at, std::max(0.0, angle - step),
                                                             std::min(std::numbers::pi, angle + step), kBits, steps)
                           .second;
  return sign * std::min(known, found);
}

}  // namespace dualarm

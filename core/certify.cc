#include "core/certify.h"

#include <algorithm>
#include <stdexcept>

#include "core/wording.h"

namespace dualarm {
namespace {

/// By how much, relative, a proven bound may exceed a verified plan: end states have a tolerance of 1e-7.
constexpr double kContradiction = 1e-6;

}  // namespace

Certificate certify(double duration, const KnownBounds& known) {
  Certificate certificate;
  certificate.lower_bound = known.fastest;
  if (known.demanded.duration > certificate.lower_bound && known.demanded.gate) {
    certificate.lower_bound = known.demanded.duration;
    certificate.source = LowerBoundSource::kPassage;
    certificate.gate = known.demanded.gate;
  }
  if (known.visit && known.visit->duration > certificate.lower_bound) {
    certificate.lower_bound = known.visit->duration;
    certificate.source = LowerBoundSource::kMovingObject;
    certificate.gate.reset();
    certificate.visit = known.visit->visit;
  }
  if (certificate.lower_bound > duration * (1.0 + kContradiction)) {
    throw std::logic_error(worded("a plan of ", duration, " s was verified, and ", certificate.lower_bound,
                                  " s were proven to be needed"));
  }
  certificate.gap = duration > 0.0 ? std::max(0.0, duration / certificate.lower_bound - 1.0) : 0.0;
  const double of_planned = std::max({certificate.lower_bound, known.planned.duration, known.planned_visit});
  if (duration <= of_planned * (1.0 + kAtBound)) {
    certificate.claim = Claim::kOptimal;
  } else if (duration <= known.monotone * (1.0 + kAtBound)) {
    certificate.claim = Claim::kOptimalMonotone;
  }
  return certificate;
}

}  // namespace dualarm

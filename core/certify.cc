#include "core/certify.h"

#include <algorithm>

namespace dualarm {
Certificate certify(double duration, const KnownBounds& known) {
  Certificate certificate;
  certificate.lower_bound = known.fastest;
  if (known.demanded.duration > known.fastest && known.demanded.gate) {
    certificate.lower_bound = known.demanded.duration;
    certificate.source = LowerBoundSource::kPassage;
    certificate.gate = known.demanded.gate;
  }
  certificate.gap = duration > 0.0 ? std::max(0.0, duration / certificate.lower_bound - 1.0) : 0.0;
  if (duration <= std::max(certificate.lower_bound, known.planned.duration) * (1.0 + kAtBound)) {
    certificate.claim = Claim::kOptimal;
  } else if (duration <= known.monotone * (1.0 + kAtBound)) {
    certificate.claim = Claim::kOptimalMonotone;
  }
  return certificate;
}

}  // namespace dualarm

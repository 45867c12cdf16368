#pragma once

namespace dualarm {

/// Round trips of fast plans and of health checks from one caller, without other load and while `searches` callers
/// keep slow searches running and queued; each for `seconds`. Prints p50 and p99.
int measure_overload(double seconds, int searches);

}  // namespace dualarm

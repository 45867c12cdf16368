#pragma once

namespace dualarm {

/// How long planning goes on after its caller has left, in processor time of the planning thread: every scenario, by
/// all methods and by the search alone, each left at `samples` random moments. Prints the longest for each; 0 if none
/// takes more than 20 ms.
int measure_stopping(int samples, unsigned seed);

}  // namespace dualarm

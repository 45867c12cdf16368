#pragma once

namespace dualarm {

/// All kinds of calls at once for so long: plans, searches, streams, batches, bad requests, calls that are cancelled or
/// whose connection goes at random moments, a client that never reads. Prints what was answered and the server's
/// memory; 0 if the server lives, nothing was lost, and memory in the last tenth is within 5 % of that in the third.
int run_mixed_load(double seconds, unsigned seed);

}  // namespace dualarm

#pragma once

namespace dualarm {

/// So many calls of PlanMotionStream, and then of PlanMotionBatch with a few requests each, open at once: all have to
/// end well.
int open_many_streams(int count);

/// So many requests, one in a hundred of them bad, through one call of PlanMotionBatch: each has to be answered once.
int plan_one_batch(int count);

/// A client that sends requests of a batch and reads no answer, for so long: the server's memory may not grow.
int refuse_to_read(double seconds);

}  // namespace dualarm

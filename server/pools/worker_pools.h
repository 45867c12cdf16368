#pragma once

#include "server/options.h"
#include "server/pools/worker_pool.h"

namespace dualarm {

/// Where computations wait and run. Apart, so that one kind never waits behind another, and with more patience the
/// longer they take: the threads of slow work stand back behind those of quick work.
struct WorkerPools {
  explicit WorkerPools(const ServerOptions& options);

  WorkerPool search;    ///< seconds: what only the search can plan
  WorkerPool drawings;  ///< regions and portraits: milliseconds as a rule, seconds where a fine one is asked for
  WorkerPool slow;  ///< tens of milliseconds: analytic plans that a trial was too short for, and plans that are watched
  WorkerPool quick;  ///< milliseconds: analytic plans, verification; last, because it hands over to the others
};

}  // namespace dualarm

#include "server/pools/worker_pools.h"

namespace dualarm {
namespace {

constexpr int kDrawingThreads = 1;

}  // namespace

WorkerPools::WorkerPools(const ServerOptions& options)
    : search({options.search_threads, options.search_queue, options.niceness}),
      drawings({kDrawingThreads, options.queue_capacity, options.niceness}),
      slow({options.worker_threads, options.queue_capacity, options.niceness / 2}),
      quick({options.worker_threads, options.queue_capacity, 0}) {}

}  // namespace dualarm

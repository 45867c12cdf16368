#include "server/heap_trimmer.h"

#include <malloc.h>

#include <chrono>

#include "server/metrics/process_figures.h"

namespace dualarm {
namespace {

constexpr std::chrono::seconds kPeriod{5};
constexpr double kWorthIt = 4.0 * 1024 * 1024;  // bytes; giving them back and taking them again costs a millisecond

}  // namespace

HeapTrimmer::HeapTrimmer() : thread_([this] { run(); }) {}

HeapTrimmer::~HeapTrimmer() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
}

void HeapTrimmer::run() {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kPeriod, [this] { return stopping_; })) {
    if (free_heap_bytes() > kWorthIt) malloc_trim(0);
  }
}

}  // namespace dualarm

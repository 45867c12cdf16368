// The server's memory comes from tcmalloc: with the C library's malloc 32 callers get fewer plans a second. Sanitizers
// bring an allocator of their own and are built without it.
#include "server/heap.h"

#ifdef DUALARM_TCMALLOC
#include <gperftools/malloc_extension.h>
#else
#include <malloc.h>
#endif

namespace dualarm {

#ifdef DUALARM_TCMALLOC

namespace {

double property(const char* name) {
  std::size_t bytes = 0;
  return MallocExtension::instance()->GetNumericProperty(name, &bytes) ? static_cast<double>(bytes) : 0.0;
}

}  // namespace

double used_heap_bytes() { return property("generic.current_allocated_bytes"); }

double free_heap_bytes() {
  return property("generic.heap_size") - property("tcmalloc.pageheap_unmapped_bytes") - used_heap_bytes();
}

void release_free_heap() { MallocExtension::instance()->ReleaseFreeMemory(); }

#else

double used_heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

double free_heap_bytes() { return static_cast<double>(mallinfo2().fordblks); }

void release_free_heap() { malloc_trim(0); }

#endif

}  // namespace dualarm

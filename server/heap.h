#pragma once

namespace dualarm {

/// Bytes that the program has allocated, and bytes that it has given back and the allocator keeps for later.
double used_heap_bytes();
double free_heap_bytes();

/// Gives the system back what the allocator keeps and can part with. A millisecond, and as much when it is taken again.
void release_free_heap();

}  // namespace dualarm

#pragma once

namespace dualarm {

/// Of this process, as Linux tells; 0 where it does not.
double resident_memory_bytes();
double open_file_count();

/// Of the heap, by the C library: what the program has allocated, and what it has given back and the library keeps.
double used_heap_bytes();
double free_heap_bytes();

}  // namespace dualarm

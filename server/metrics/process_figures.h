#pragma once

namespace dualarm {

/// Of this process, as Linux tells; 0 where it does not.
double resident_memory_bytes();
double open_file_count();

}  // namespace dualarm

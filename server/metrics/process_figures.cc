#include "server/metrics/process_figures.h"

#include <malloc.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace dualarm {

double resident_memory_bytes() {
  std::ifstream file("/proc/self/statm");
  double all_pages = 0.0;
  double resident_pages = 0.0;
  file >> all_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double used_heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

double free_heap_bytes() { return static_cast<double>(mallinfo2().fordblks); }

double open_file_count() {
  std::error_code error;
  const std::filesystem::directory_iterator files("/proc/self/fd", error);
  return error ? 0.0 : static_cast<double>(std::distance(begin(files), end(files)) - 1);  // one is this look
}

}  // namespace dualarm

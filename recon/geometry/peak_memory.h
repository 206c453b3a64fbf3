#pragma once

#include <sys/resource.h>

#include <cstddef>

namespace isostack {

/// The most memory this process has held at any time so far, in bytes.
inline std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace isostack

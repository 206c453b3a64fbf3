#include "recon/solvers/memory_limit.h"

#include <fmt/format.h>

#include "recon/geometry/errors.h"

namespace isostack {

void require_memory(std::size_t constraint_count, std::size_t needed_bytes, std::size_t limit_bytes) {
  if (needed_bytes <= limit_bytes) return;
  throw SolveError("solve",
                   fmt::format("{} constraints need {:.2f} GB and {:.2f} GB are allowed", constraint_count,
                               static_cast<double>(needed_bytes) / 1e9, static_cast<double>(limit_bytes) / 1e9),
                   "allow more with --memory or use fewer constraints");
}

}  // namespace isostack

#pragma once

#include <cstddef>

namespace isostack {

/// Throws SolveError before anything is allocated when a solve would need more than is allowed.
void require_memory(std::size_t constraint_count, std::size_t needed_bytes, std::size_t limit_bytes);

}  // namespace isostack

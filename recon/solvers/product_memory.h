#pragma once

#include <cstddef>

#include "recon/solvers/octree.h"
#include "recon/solvers/source_field.h"

namespace isostack {

/// Memory of a fast sum's far field, from the cells of its tree; known without making it.
struct ProductMemory {
  std::size_t sources = 0;  ///< multipoles, spectra and translation tables
  std::size_t targets = 0;  ///< local expansions and lists of cells, when the targets are the sources
};
ProductMemory product_memory(const Octree& tree, const FarFieldOptions& options);

}  // namespace isostack

#include "recon/solvers/product_memory.h"

#include <algorithm>
#include <cmath>

#include "recon/solvers/interactions.h"
#include "recon/solvers/sibling_groups.h"
#include "recon/solvers/spectrum_blocks.h"

namespace isostack {

namespace {

constexpr std::size_t listed_cells = 60;  ///< far and near cells of a cell, by measurement on contours

}  // namespace

ProductMemory product_memory(const Octree& tree, const FarFieldOptions& options) {
  ProductMemory memory;
  for (int l = SourceField::top_level; l < tree.level_count(); ++l) {
    const int order = order_at(options, tree.depth() - l);
    const auto nodes =
        static_cast<std::size_t>(order) * static_cast<std::size_t>(order) * static_cast<std::size_t>(order);
    const auto padded = static_cast<std::size_t>(2 * order - 1);
    const std::size_t blocks =
        (padded * padded * static_cast<std::size_t>(order) + frequency_block - 1) / frequency_block;
    const std::size_t spectrum = blocks * block_doubles * sizeof(double);
    const std::size_t cells = tree.level(l).size();
    const std::size_t expansions = SiblingGroups(tree, l).groups.size() * nodes * sibling_lanes * sizeof(double);
    // Few cells lie in few places as seen from each other.
    const std::size_t offsets = std::min<std::size_t>(Interactions::offset_count - 27, cells * cells);
    memory.sources += expansions + (cells + offsets) * spectrum;
    memory.targets += expansions + cells * listed_cells * (sizeof(QuadTerm) + sizeof(Interactions::Far));
  }
  return memory;
}

}  // namespace isostack

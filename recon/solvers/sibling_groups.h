#pragma once

#include <cstdint>
#include <vector>

#include "recon/solvers/expansions.h"
#include "recon/solvers/octree.h"

namespace isostack {

/// The sibling groups of one octree level: the children of one cell share a group, one lane each.
struct SiblingGroups {
  struct Group {
    std::uint32_t parent;       ///< index into the level above
    std::uint32_t first, last;  ///< cells of this level
  };
  std::vector<Group> groups;
  std::vector<std::uint32_t> group_of_cell;

  SiblingGroups() = default;
  SiblingGroups(const Octree& tree, int level);
};

CellFrame cell_frame(const Octree& tree, int level, std::uint32_t cell);
PointArrays points_of(const Octree& tree, const Octree::Cell& cell);
/// Points first to last in tree order.
PointArrays points_between(const Octree& tree, std::uint32_t first, std::uint32_t last);

}  // namespace isostack

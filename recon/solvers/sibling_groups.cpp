#include "recon/solvers/sibling_groups.h"

namespace isostack {

SiblingGroups::SiblingGroups(const Octree& tree, int level) {
  if (level >= tree.level_count()) return;
  group_of_cell.resize(tree.level(level).size());
  const auto& parents = tree.level(level - 1);
  for (std::uint32_t p = 0; p < parents.size(); ++p) {
    if (parents[p].leaf()) continue;
    for (std::uint32_t c = parents[p].first_child; c < parents[p].last_child; ++c)
      group_of_cell[c] = static_cast<std::uint32_t>(groups.size());
    groups.push_back({p, parents[p].first_child, parents[p].last_child});
  }
}

CellFrame cell_frame(const Octree& tree, int level, std::uint32_t cell) {
  const Eigen::Vector3d centre = tree.cell_centre(level, tree.level(level)[cell]);
  return {{centre[0], centre[1], centre[2]}, tree.cell_width(level) / 2};
}

PointArrays points_of(const Octree& tree, const Octree::Cell& cell) {
  return points_between(tree, cell.first, cell.last);
}

PointArrays points_between(const Octree& tree, std::uint32_t first, std::uint32_t last) {
  return {tree.coordinates(0).data() + first, tree.coordinates(1).data() + first, tree.coordinates(2).data() + first,
          last - first};
}

}  // namespace isostack

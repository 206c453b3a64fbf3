#include "recon/morphing/unshared_parts.h"

#include <cmath>
#include <utility>

#include "segmentation/lattice.h"

namespace isostack {

namespace {

bool is_inside(float distance_mm) { return distance_mm >= 0; }

/// All nodes on the first one's side of the target that connect to it.
template <int D>
std::vector<std::size_t> connected_to(std::size_t first, const Field<D>& target, const Lattice<D>& lattice,
                                      std::vector<bool>& seen) {
  std::vector<std::size_t> nodes{first};
  seen[first] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t node = nodes[i];
    lattice.for_each_neighbour(lattice.sides_of(node), [&](int, std::ptrdiff_t step) {
      const std::size_t next = lattice.moved(node, step);
      if (seen[next] || is_inside(target.values[next]) != is_inside(target.values[first])) return;
      seen[next] = true;
      nodes.push_back(next);
    });
  }
  return nodes;
}

template <int D>
bool is_shared(const std::vector<std::size_t>& nodes, const Field<D>& start, const Field<D>& target) {
  for (const std::size_t node : nodes)
    if (is_inside(start.values[node]) == is_inside(target.values[node])) return true;
  return false;
}

}  // namespace

template <int D>
std::vector<UnsharedRegion> unshared_regions(const Field<D>& start, const Field<D>& target) {
  const Lattice<D> lattice(target);
  const double least_depth_mm = target.smallest_spacing_mm() / 2;
  std::vector<UnsharedRegion> regions;
  std::vector<bool> seen(target.values.size());
  for (std::size_t first = 0; first < target.values.size(); ++first) {
    if (seen[first]) continue;
    UnsharedRegion region{.is_inside = is_inside(target.values[first]),
                          .deepest = first,
                          .nodes = connected_to(first, target, lattice, seen)};
    if (is_shared(region.nodes, start, target)) continue;
    for (const std::size_t node : region.nodes)
      if (std::abs(target.values[node]) > std::abs(target.values[region.deepest])) region.deepest = node;
    region.depth_mm = std::abs(target.values[region.deepest]);
    if (region.depth_mm > least_depth_mm) regions.push_back(std::move(region));
  }
  return regions;
}

template std::vector<UnsharedRegion> unshared_regions(const Field<2>&, const Field<2>&);
template std::vector<UnsharedRegion> unshared_regions(const Field<3>&, const Field<3>&);

}  // namespace isostack

#include "recon/distance/mesh_topology.h"

#include <algorithm>

namespace isostack {

namespace {

/// Sorts `count` items into lists; list_of(item) < 0 leaves an item out. Items keep their order.
template <class ListOf>
Lists sorted_into(std::size_t lists, int count, ListOf list_of) {
  Lists result;
  result.begin.assign(lists + 1, 0);
  for (int item = 0; item < count; ++item)
    if (list_of(item) >= 0) ++result.begin[static_cast<std::size_t>(list_of(item)) + 1];
  for (std::size_t list = 0; list < lists; ++list) result.begin[list + 1] += result.begin[list];
  result.items.resize(static_cast<std::size_t>(result.begin.back()));
  std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
  for (int item = 0; item < count; ++item)
    if (list_of(item) >= 0)
      result.items[static_cast<std::size_t>(next[static_cast<std::size_t>(list_of(item))]++)] = item;
  return result;
}

MeshTopology::Edge ends_of(const TriangleMesh& mesh, int side) {
  const auto [low, high] = std::minmax({corner(mesh, side / 3, side % 3), corner(mesh, side / 3, side % 3 + 1)});
  return {low, high};
}

}  // namespace

MeshTopology topology_of(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.vertices_mm.size();
  const int sides = 3 * static_cast<int>(mesh.triangles.size());
  MeshTopology topology;
  topology.triangles_of_vertex =
      sorted_into(vertices, sides, [&](int side) { return corner(mesh, side / 3, side % 3); });
  for (int& side : topology.triangles_of_vertex.items) side /= 3;

  Lists by_low = sorted_into(vertices, sides, [&](int side) {
    const MeshTopology::Edge ends = ends_of(mesh, side);
    return ends.low == ends.high ? -1 : ends.low;
  });
  topology.sides_of_edge.begin.push_back(0);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = by_low.items.begin() + by_low.begin[v], last = by_low.items.begin() + by_low.begin[v + 1];
    std::stable_sort(first, last, [&](int a, int b) { return ends_of(mesh, a).high < ends_of(mesh, b).high; });
    for (auto side = first; side != last; ++side) {
      const MeshTopology::Edge ends = ends_of(mesh, *side);
      if (side == first || topology.edges.back().high != ends.high) {
        topology.edges.push_back(ends);
        topology.sides_of_edge.begin.push_back(topology.sides_of_edge.begin.back());
      }
      ++topology.sides_of_edge.begin.back();
    }
  }
  topology.sides_of_edge.items = std::move(by_low.items);

  const int ends = 2 * static_cast<int>(topology.edges.size());
  topology.edges_of_vertex = sorted_into(vertices, ends, [&](int end) {
    const MeshTopology::Edge& edge = topology.edges[static_cast<std::size_t>(end / 2)];
    return end % 2 == 0 ? edge.low : edge.high;
  });
  for (int& end : topology.edges_of_vertex.items) end /= 2;
  return topology;
}

}  // namespace isostack

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/metrics/point_triangle.h"

namespace isostack {

/// Lists of unequal length, one after the other.
struct Lists {
  std::vector<int> begin;  ///< of each list, and the end of the last
  std::vector<int> items;

  std::span<const int> operator[](int list) const {
    const auto at = static_cast<std::size_t>(list);
    return {items.data() + begin[at], static_cast<std::size_t>(begin[at + 1] - begin[at])};
  }
};

/// Which elements of a mesh touch which. Sides are 3 × triangle + corner, from that corner to the next.
struct MeshTopology {
  struct Edge {
    int low, high;  ///< vertices, low < high
  };
  std::vector<Edge> edges;
  Lists sides_of_edge;
  Lists edges_of_vertex;
  Lists triangles_of_vertex;
};

/// In time linear in the triangles (meshes with a bounded number of edges at a vertex). Sides of no length make no
/// edge.
MeshTopology topology_of(const TriangleMesh& mesh);

inline int corner(const TriangleMesh& mesh, int triangle, int number) {
  return mesh.triangles[static_cast<std::size_t>(triangle)][number % 3];
}
inline const Eigen::Vector3d& vertex_mm(const TriangleMesh& mesh, int vertex) {
  return mesh.vertices_mm[static_cast<std::size_t>(vertex)];
}
inline Triangle triangle_of(const TriangleMesh& mesh, int triangle) {
  return {vertex_mm(mesh, corner(mesh, triangle, 0)), vertex_mm(mesh, corner(mesh, triangle, 1)),
          vertex_mm(mesh, corner(mesh, triangle, 2))};
}

}  // namespace isostack

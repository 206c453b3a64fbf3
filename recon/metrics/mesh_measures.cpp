#include "recon/metrics/mesh_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "recon/geometry/disjoint_sets.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Directed edges as (low vertex, high vertex, direction), sorted so that equal ones meet.
struct Edge {
  int low, high;
  bool forward;
  auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int side = 0; side < 3; ++side) {
      const int from = t[side], to = t[(side + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Classifies edges; returns the number of different ones.
std::size_t count_edges(const std::vector<Edge>& edges, MeshMeasures& measures) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i, forward = 0;
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end)
      forward += edges[end].forward ? 1 : 0;
    const std::size_t uses = end - i;
    if (uses == 1) ++measures.boundary_edges;
    if (uses > 2) ++measures.non_manifold_edges;
    if (uses == 2 && forward != 1) ++measures.flipped_edges;
    ++different;
    i = end;
  }
  return different;
}

}  // namespace

MeshMeasures measure(const TriangleMesh& mesh) {
  MeshMeasures measures;
  measures.triangles = mesh.triangles.size();
  DisjointSets parts(mesh.vertices_mm.size());
  std::vector<bool> used(mesh.vertices_mm.size(), false);
  const Eigen::Vector3d reference_mm = mesh.vertices_mm.empty() ? Eigen::Vector3d(0, 0, 0) : mesh.vertices_mm.front();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= static_cast<int>(used.size()))
      throw InputError(mesh.name.empty() ? "mesh" : mesh.name, "a triangle refers to a vertex that does not exist",
                       "write the mesh again");
    Eigen::Vector3d corner[3];
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(t[c]);
      corner[c] = mesh.vertices_mm[v] - reference_mm;
      used[v] = true;
      parts.join(v, static_cast<std::size_t>(t[0]));
    }
    measures.volume_mm3 += corner[0].dot(corner[1].cross(corner[2])) / 6;
    measures.area_mm2 += (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    ++measures.vertices;
    if (parts.root(v) == v) ++measures.components;
  }
  const std::size_t edges = count_edges(sorted_edges(mesh), measures);
  measures.euler_characteristic =
      static_cast<long>(measures.vertices) - static_cast<long>(edges) + static_cast<long>(measures.triangles);
  measures.genus = static_cast<double>(measures.components) - static_cast<double>(measures.euler_characteristic) / 2;
  return measures;
}

}  // namespace isostack

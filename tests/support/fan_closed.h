#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack::testing_support {

/// The mesh with each rim closed by a fan of triangles to the rim's centroid.
inline TriangleMesh fan_closed(TriangleMesh mesh) {
  std::set<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
  std::map<int, int> rim;  // from each vertex on an edge with one triangle to the next one
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) rim[a] = b;
  while (!rim.empty()) {
    std::vector<int> loop;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (auto at = rim.begin(); at != rim.end(); at = rim.find(loop.back())) {
      sum += mesh.vertices_mm[static_cast<std::size_t>(at->first)];
      loop.push_back(at->second);
      rim.erase(at);
    }
    const auto centre = static_cast<int>(mesh.vertices_mm.size());
    mesh.vertices_mm.emplace_back(sum / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i)
      mesh.triangles.emplace_back(loop[(i + 1) % loop.size()], loop[i], centre);
    mesh.normals.clear();
  }
  return mesh;
}

}  // namespace isostack::testing_support

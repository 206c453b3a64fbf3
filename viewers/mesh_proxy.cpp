#include "viewers/mesh_proxy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace isostack {

namespace {

double area_mm2(const TriangleMesh& mesh) {
  double area = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices_mm[static_cast<std::size_t>(t.x())],
                          &b = mesh.vertices_mm[static_cast<std::size_t>(t.y())],
                          &c = mesh.vertices_mm[static_cast<std::size_t>(t.z())];
    area += (b - a).cross(c - a).norm() / 2;
  }
  return area;
}

/// Groups vertices by cell; new_index tells of each vertex the vertex of the proxy it went into.
MeshProxy clustered_vertices(const TriangleMesh& mesh, double cell_mm, std::vector<int>& new_index) {
  MeshProxy proxy;
  proxy.mesh.name = mesh.name;
  proxy.mesh.color = mesh.color;
  const bool has_normals = mesh.normals.size() == mesh.vertices_mm.size();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  std::unordered_map<std::uint64_t, int> cells;
  cells.reserve(mesh.vertices_mm.size() / 4);
  std::vector<double> members;
  new_index.resize(mesh.vertices_mm.size());
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const Eigen::Vector3d place = (mesh.vertices_mm[i] - box.min()) / cell_mm;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) key = (key << 21U) | (static_cast<std::uint64_t>(place[axis]) & 0x1FFFFFU);
    const auto [found, is_new] = cells.try_emplace(key, static_cast<int>(proxy.source_vertex.size()));
    new_index[i] = found->second;
    const auto to = static_cast<std::size_t>(found->second);
    if (is_new) {
      proxy.mesh.vertices_mm.emplace_back(0, 0, 0);
      if (has_normals) proxy.mesh.normals.emplace_back(0, 0, 0);
      proxy.source_vertex.push_back(i);
      members.push_back(0);
    }
    proxy.mesh.vertices_mm[to] += mesh.vertices_mm[i];
    if (has_normals) proxy.mesh.normals[to] += mesh.normals[i];
    ++members[to];
  }
  for (std::size_t i = 0; i < members.size(); ++i) proxy.mesh.vertices_mm[i] /= members[i];
  for (Eigen::Vector3d& normal : proxy.mesh.normals) normal.normalize();
  return proxy;
}

}  // namespace

MeshProxy mesh_proxy(const TriangleMesh& mesh, std::size_t triangles) {
  // A surface of area A meets about 1.5 A / h² cells of edge h (its mean over directions), and has two triangles for
  // each of its vertices.
  const double cell_mm = std::sqrt(3 * area_mm2(mesh) / static_cast<double>(std::max<std::size_t>(triangles, 1)));
  std::vector<int> new_index;
  MeshProxy proxy = clustered_vertices(mesh, std::max(cell_mm, 1e-9), new_index);
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3i moved(new_index[static_cast<std::size_t>(t.x())], new_index[static_cast<std::size_t>(t.y())],
                                new_index[static_cast<std::size_t>(t.z())]);
    if (moved.x() != moved.y() && moved.y() != moved.z() && moved.z() != moved.x())
      proxy.mesh.triangles.push_back(moved);
  }
  return proxy;
}

}  // namespace isostack

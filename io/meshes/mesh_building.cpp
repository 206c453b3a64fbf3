#include "io/meshes/mesh_building.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {

void add_polygon(std::span<const long long> corners, TriangleMesh& mesh, const std::string& where) {
  const auto vertex_count = static_cast<long long>(mesh.vertices_mm.size());
  for (const long long corner : corners)
    if (corner < 0 || corner >= vertex_count)
      throw InputError(where, fmt::format("a face names vertex {} of {}", corner, vertex_count), "repair the mesh");
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.emplace_back(static_cast<int>(corners[0]), static_cast<int>(corners[i - 1]),
                                static_cast<int>(corners[i]));
}

void complete_mesh(TriangleMesh& mesh, const std::string& where) {
  if (mesh.triangles.empty())
    throw InputError(where, "there is no triangle in it", "it is empty, truncated or not a surface mesh");
  const bool finite = std::all_of(mesh.vertices_mm.begin(), mesh.vertices_mm.end(),
                                  [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); });
  if (!finite) throw InputError(where, "a vertex has a coordinate that is not a number", "repair the mesh");
  if (mesh.normals.size() != mesh.vertices_mm.size()) mesh.normals.clear();
  for (Eigen::Vector3d& normal : mesh.normals) normal.normalize();
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

void CommonColor::add(const Eigen::Vector3d& channels) {
  if (differs_) return;
  const bool is_color = channels.allFinite() && channels.minCoeff() >= 0 && channels.maxCoeff() <= 255;
  const auto channel = [&](int i) { return static_cast<std::uint8_t>(std::lround(channels[i])); };
  const Color color = is_color ? Color{channel(0), channel(1), channel(2)} : Color{};
  if (is_color && !color_) color_ = color;
  differs_ = !is_color || *color_ != color;
}

void merge_coinciding(TriangleMesh& mesh) {
  std::map<std::array<double, 3>, int> index_of;
  std::vector<int> merged(mesh.vertices_mm.size());
  std::vector<Eigen::Vector3d> vertices, normals;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const Eigen::Vector3d& v = mesh.vertices_mm[i];
    const auto [entry, is_new] = index_of.try_emplace({v.x(), v.y(), v.z()}, static_cast<int>(vertices.size()));
    merged[i] = entry->second;
    if (is_new) vertices.push_back(v);
    if (mesh.normals.empty()) continue;
    if (is_new)
      normals.push_back(mesh.normals[i]);
    else
      normals[static_cast<std::size_t>(entry->second)] += mesh.normals[i];
  }
  for (Eigen::Vector3d& normal : normals) normal.normalize();
  for (Eigen::Vector3i& triangle : mesh.triangles)
    for (int& corner : triangle) corner = merged[static_cast<std::size_t>(corner)];
  std::erase_if(mesh.triangles, [](const Eigen::Vector3i& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  mesh.vertices_mm = std::move(vertices);
  mesh.normals = std::move(normals);
}

}  // namespace isostack

#include "recon/surface/islands.h"

#include <algorithm>
#include <utility>

namespace isostack {

std::optional<TriangleMesh> extract_island(const ScalarField& field, const std::vector<Eigen::Vector3d>& seeds_mm,
                                           const Eigen::AlignedBox3d& box, double resolution_mm,
                                           const ExtractionOptions& surface_options) {
  ExtractionOptions options = surface_options;
  options.resolution_mm = resolution_mm;
  options.bounds = box.intersection(surface_options.bounds);
  options.may_be_empty = true;
  ExtractedSurface extracted = extract_surface(field, seeds_mm, options);
  if (extracted.cut_by_bounds || extracted.mesh.triangles.empty() || !extracted.seeds_without_surface.empty())
    return std::nullopt;
  return std::move(extracted.mesh);
}

bool add_island(const TriangleMesh& island, double cell_mm, TriangleMesh& surface) {
  Eigen::AlignedBox3d around;
  for (const Eigen::Vector3d& vertex : island.vertices_mm) around.extend(vertex);
  around.min().array() -= cell_mm;
  around.max().array() += cell_mm;
  const auto is_near = [&](const Eigen::Vector3d& vertex) {
    return around.contains(vertex) &&
           std::any_of(island.vertices_mm.begin(), island.vertices_mm.end(),
                       [&](const Eigen::Vector3d& other) { return (vertex - other).norm() < cell_mm; });
  };
  if (std::any_of(surface.vertices_mm.begin(), surface.vertices_mm.end(), is_near)) return false;
  const auto first = static_cast<int>(surface.vertices_mm.size());
  surface.vertices_mm.insert(surface.vertices_mm.end(), island.vertices_mm.begin(), island.vertices_mm.end());
  surface.normals.insert(surface.normals.end(), island.normals.begin(), island.normals.end());
  for (const Eigen::Vector3i& triangle : island.triangles) surface.triangles.emplace_back(triangle.array() + first);
  return true;
}

}  // namespace isostack

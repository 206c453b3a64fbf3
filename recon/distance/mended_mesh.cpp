#include "recon/distance/mended_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/distance/distance_surface.h"
#include "recon/distance/mesh_distance.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/voxelize.h"

namespace isostack {

namespace {

constexpr double voxels_of_longest_side = 100, margin_voxels = 4;

std::string place(const TriangleMesh& mesh) { return mesh.name.empty() ? "mesh" : mesh.name; }

Grid grid_round(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  const double voxel_mm = box.sizes().maxCoeff() / voxels_of_longest_side;
  return distance_grid(mesh, voxel_mm, margin_voxels * voxel_mm);
}

std::string overlap_at(const Eigen::Vector3d& p) {
  return fmt::format("it crosses itself: the place {:.4g}, {:.4g}, {:.4g} is not enclosed just once", p.x(), p.y(),
                     p.z());
}

}  // namespace

void require_no_overlap(const TriangleMesh& mesh) {
  if (const auto found = doubly_enclosed(mesh, grid_round(mesh)))
    throw InputError(place(mesh), overlap_at(*found), "repair the mesh, or have it mended");
}

MendedMesh mended_mesh(const TriangleMesh& mesh, const Progress& progress) {
  MendedMesh result;
  const Grid grid = grid_round(mesh);  // refuses what is no mesh
  const MeshMeasures measures = measure(mesh);
  if (measures.watertight() && measures.volume_mm3 > 0) {
    const auto overlap = doubly_enclosed(mesh, grid);
    if (!overlap) {
      result.mesh = mesh;
      return result;
    }
    result.remarks.push_back(overlap_at(*overlap) + "; overlapping parts were united");
  }
  MeshDistance found =
      mesh_distance(mesh, grid, {.band_mm = 0, .extent = DistanceExtent::band, .sign = MeshSign::by_winding}, progress);
  if (std::none_of(found.distance_mm.voxels.begin(), found.distance_mm.voxels.end(), [](float mm) { return mm > 0; }))
    throw InputError(place(mesh), "it encloses nothing that a hundredth of its size would show", "give a closed mesh");
  result.mesh = distance_surface(found.distance_mm, {}, progress);
  result.mesh.name = mesh.name;
  result.mesh.color = mesh.color;
  std::move(found.remarks.begin(), found.remarks.end(), std::back_inserter(result.remarks));
  if (measures.non_manifold_edges > 0)
    result.remarks.push_back(fmt::format("{} edges have more than two triangles", measures.non_manifold_edges));
  if (result.remarks.empty()) result.remarks.emplace_back("it was turned inside out");
  result.remarks.push_back(fmt::format("the surface of its distance volume took its place, cells {:.3g} mm",
                                       grid.index_to_world.linear()(0, 0)));
  return result;
}

}  // namespace isostack

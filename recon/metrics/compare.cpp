#include "recon/metrics/compare.h"

#include <Eigen/Geometry>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/metrics/overlap.h"
#include "recon/metrics/voxel_surface.h"
#include "recon/metrics/voxelize.h"

namespace isostack {

namespace {

Eigen::AlignedBox3d box_round(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  return box;
}

/// A cubic grid round both meshes with about 200 voxels along the diagonal.
Grid common_grid(const TriangleMesh& a, const TriangleMesh& b) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh* mesh : {&a, &b})
    for (const Eigen::Vector3d& v : mesh->vertices_mm) box.extend(v);
  const double spacing_mm = box.diagonal().norm() / 200;
  Grid grid;
  grid.size = (box.sizes() / spacing_mm).array().ceil().cast<int>() + 2;
  grid.index_to_world = Eigen::Translation3d(box.min()) * Eigen::Scaling(spacing_mm);
  return grid;
}

LabelVolume on_grid(const MeasuredBody& body, const Grid& grid) {
  if (body.labels) return *body.labels;
  LabelVolume labels(grid);
  voxelize(body.mesh, 1, labels);
  return labels;
}

Overlap overlap_of(const MeasuredBody& a, const MeasuredBody& b) {
  const Grid grid = a.labels ? a.labels->grid : b.labels ? b.labels->grid : common_grid(a.mesh, b.mesh);
  if (a.labels && b.labels && !a.labels->grid.index_to_world.isApprox(b.labels->grid.index_to_world, 1e-4))
    throw InputError("measure", "the two label volumes lie on different grids",
                     "put one on the other's grid with --grid");
  return overlap(on_grid(a, grid), on_grid(b, grid));
}

}  // namespace

MeasuredBody measured(TriangleMesh mesh) {
  const MeshMeasures measures = measure(mesh);
  return {std::move(mesh), measures, std::nullopt};
}

MeasuredBody measured(LabelVolume labels, const std::string& where) {
  MeasuredBody body = measured(voxel_surface(labels));
  if (body.mesh.triangles.empty()) throw InputError(where, "no voxel has the label", "choose a label that is there");
  body.labels = std::move(labels);
  return body;
}

BodyComparison compare(const MeasuredBody& first, const MeasuredBody& second, const SurfaceDistanceOptions& options) {
  BodyComparison result{.dice = overlap_of(first, second).dice,
                        .distance = surface_distance(first.mesh, second.mesh, options),
                        .diagonal_mm = box_round(second.mesh).diagonal().norm(),
                        .volume_difference_mm3 = first.measures.volume_mm3 - second.measures.volume_mm3};
  if (!first.labels && !second.labels) result.area_difference_mm2 = first.measures.area_mm2 - second.measures.area_mm2;
  return result;
}

}  // namespace isostack

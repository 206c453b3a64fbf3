#include "recon/distance/solid.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/distance/band_scan.h"
#include "recon/distance/carry_outwards.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/closest_point.h"

namespace isostack {

using Eigen::Vector3d;

namespace {

std::string place(const CsgSolid& solid) { return solid.name.empty() ? "solid" : solid.name; }

void require_usable(const CsgSolid& solid, const std::string& where) {
  if (solid.kind != CsgSolid::Kind::superellipsoid) {
    if (solid.parts.empty()) throw InputError(where, "a set operation has no parts", "give one solid or more");
    for (const CsgSolid& part : solid.parts) require_usable(part, part.name.empty() ? where : part.name);
    return;
  }
  if (!solid.radii_mm.allFinite() || solid.radii_mm.minCoeff() <= 0)
    throw InputError(where, "a radius is not above 0", "give three lengths in mm");
  if (!solid.exponents.allFinite() || solid.exponents.minCoeff() < 0.1 || solid.exponents.maxCoeff() > 2)
    throw InputError(where, "an exponent is not from 0.1 to 2", "give 1 for round, 0.1 for nearly square");
  const double volume = std::abs(solid.to_world.linear().determinant());
  if (!solid.to_world.matrix().allFinite() || !(volume > 0))
    throw InputError(where, "its affine map flattens it", "give a map that can be undone");
}

double checked_tolerance(const CsgSolid& solid, double tolerance_mm) {
  require_usable(solid, place(solid));
  if (!(tolerance_mm >= 0) || !std::isfinite(tolerance_mm))
    throw InputError(place(solid), "its tolerance is not a length", "give millimetres, or 0");
  return tolerance_mm > 0 ? tolerance_mm : 2.5e-4 * box_of(solid).diagonal().norm();
}

}  // namespace

Eigen::AlignedBox3d box_of(const CsgSolid& solid) {
  Eigen::AlignedBox3d box;
  if (solid.kind == CsgSolid::Kind::superellipsoid) {
    for (int c = 0; c < 8; ++c) {
      const Vector3d side(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
      box.extend(solid.to_world * solid.radii_mm.cwiseProduct(side));
    }
    return box;
  }
  for (const CsgSolid& part : solid.parts) {
    if (&part == &solid.parts.front() || solid.kind == CsgSolid::Kind::set_union)
      box.extend(box_of(part));
    else if (solid.kind == CsgSolid::Kind::intersection)
      box = box.intersection(box_of(part));
  }
  return box;
}

Grid distance_grid(const CsgSolid& solid, double spacing_mm, double margin_mm) {
  require_usable(solid, place(solid));
  if (!(spacing_mm > 0)) throw InputError(place(solid), "its voxels have no size", "give a spacing above 0 mm");
  const Eigen::AlignedBox3d box = box_of(solid);
  if (box.isEmpty()) throw InputError(place(solid), "it is empty", "let its parts overlap");
  Grid grid;
  grid.size = ((box.sizes().array() + 2 * margin_mm) / spacing_mm).ceil().cast<int>() + 1;
  grid.index_to_world.linear() *= spacing_mm;
  grid.index_to_world.translation() = box.center() - 0.5 * spacing_mm * (grid.size.array() - 1).matrix().cast<double>();
  return grid;
}

namespace {

/// Distances to the zero set within the band, infinite beyond it; the triangles they are to.
CarriedDistances near_distances(const TriangleMesh& zero_set, const Grid& grid, double band_mm,
                                const Progress& progress) {
  const MeshTopology topology = topology_of(zero_set);
  const MeshCells cells(zero_set, topology, grid, band_mm);
  BandDistances band = scan_band(zero_set, topology, grid, band_mm, progress);
  CarriedDistances known{std::move(band.mm), std::vector<int>(grid.voxel_count(), -1)};
  for (std::size_t voxel = 0; voxel < known.triangle.size(); ++voxel)
    if (band.element[voxel] >= 0) known.triangle[voxel] = cells.triangle_of(band.element[voxel]);
  // This finds what rounding may have left out between two cells.
  carry_outwards(zero_set, topology, grid, {}, band_mm, known);
  return known;
}

}  // namespace

SolidDistance solid_distance(const CsgSolid& solid, const Grid& grid, const SolidDistanceOptions& options,
                             const Progress& progress) {
  SolidDistance result;
  result.error_mm = checked_tolerance(solid, options.tolerance_mm);
  const double band_mm = checked_band_mm(options.band_mm, grid);
  const TriangleMesh zero_set = solid_samples(solid, result.error_mm);
  const CarriedDistances near = near_distances(zero_set, grid, band_mm, progress);
  const ClosestPoint anywhere(zero_set);
  result.distance_mm = Volume<float>(grid);
  if (options.keep_closest)
    result.closest_points_mm.assign(grid.voxel_count(), Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (int k = 0; k < grid.size.z(); ++k) {
    progress.report("distances", static_cast<double>(k) / grid.size.z());
    tbb::parallel_for(0, grid.size.y(), [&](int j) {
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vector3d point = grid.index_to_world * Vector3d(i, j, k);
        const std::size_t voxel = grid.offset(i, j, k);
        std::optional<Vector3d> closest;
        if (near.triangle[voxel] < 0 && options.extent == DistanceExtent::full) closest = anywhere.on_mesh(point);
        if (near.triangle[voxel] >= 0 && options.keep_closest)
          closest = closest_point_on_triangle(triangle_of(zero_set, near.triangle[voxel]), point);
        const float mm = near.triangle[voxel] >= 0 ? near.mm[voxel]
                                                   : static_cast<float>(closest ? (*closest - point).norm() : band_mm);
        result.distance_mm.voxels[voxel] = implicit_value(solid, point) > 0 ? mm : -mm;
        if (options.keep_closest && closest) result.closest_points_mm[voxel] = *closest;
      }
    });
  }
  return result;
}

}  // namespace isostack

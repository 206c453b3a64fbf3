#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// The zero set of f round the seeds in cells of their own, where it is closed within the box: a part too small for the
/// cells that the rest of the surface has. Nothing where there is none, and where it goes on beyond the box or the
/// surface's bounds.
std::optional<TriangleMesh> extract_island(const ScalarField& field, const std::vector<Eigen::Vector3d>& seeds_mm,
                                           const Eigen::AlignedBox3d& box, double resolution_mm,
                                           const ExtractionOptions& surface_options);

/// Adds an island to a surface in cells of `cell_mm`; false, and nothing is done, where the two have vertices nearer
/// than a cell: they might cross, or the surface might hold the island already.
bool add_island(const TriangleMesh& island, double cell_mm, TriangleMesh& surface);

}  // namespace isostack

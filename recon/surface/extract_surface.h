#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

struct ExtractionOptions {
  double resolution_mm = 1;                               ///< edge of the cells that are visited
  Eigen::AlignedBox3d bounds;                             ///< the surface is cut off, and closed, at this box
  std::vector<Eigen::Hyperplane<double, 3>> half_spaces;  ///< and where one of these is negative
  double vertex_tolerance = 1e-4;  ///< how far a vertex may be from f = 0 along its edge, in cells
  bool may_be_empty = false;       ///< no surface at all is a result (a mesh without triangles), not an error
};

struct ExtractedSurface {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward, with normals from ∇f
  /// Indices of seeds with no crossed cell around them: structures below the resolution.
  std::vector<std::size_t> seeds_without_surface;
  bool cut_by_bounds = false;  ///< part of the surface is the box
};

/// The zero set of f that passes near the seeds (Bloomenthal 1994): starts at the cells round the
/// seeds and visits only cells the surface passes. Vertices are roots of f along cell edges.
/// Throws GeometryError when no surface is found at all, unless it may be empty.
ExtractedSurface extract_surface(const ScalarField& field, const std::vector<Eigen::Vector3d>& seeds_mm,
                                 const ExtractionOptions& options, const Progress& progress = {});

}  // namespace isostack

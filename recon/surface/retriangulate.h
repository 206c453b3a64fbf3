#pragma once

#include <cstddef>
#include <optional>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/metrics/mesh_quality.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// What a surface's triangles are to be like. By default they stay as they are.
struct RetriangulationOptions {
  double edge_length_mm = 0;         ///< isotropic remeshing with edges of this length; 0: none
  double simplify_tolerance_mm = 0;  ///< fewer triangles, at most this far from the surface as it was; 0: none
  std::size_t triangles = 0;         ///< fewer triangles, down to this many; 0: none

  bool any() const { return edge_length_mm > 0 || simplify_tolerance_mm > 0 || triangles > 0; }
};

/// What came of it, for reports.
struct RetriangulationReport {
  std::size_t triangles_before = 0, triangles_after = 0;
  double mean_distance_mm = 0, largest_distance_mm = 0;  ///< between the surface before and after, both ways
  std::size_t vertices_off_surface = 0;                  ///< remeshed with a field: vertices without a root near them
  MeshQuality quality;                                   ///< afterwards
  double seconds = 0;
};

/// Remeshes (recon/surface/remesh.h), then simplifies (recon/surface/simplify.h) as asked for. With a field, remeshed
/// vertices lie on its zero set and normals come from ∇f; otherwise they lie on the mesh that was given, and normals
/// are those of the triangles, weighted by area. Keeps name, colour, parts, handles and borders.
/// Throws GeometryError when the mesh is not 2-manifold or would get too many triangles.
TriangleMesh retriangulate(const TriangleMesh& mesh, const RetriangulationOptions& options,
                           RetriangulationReport& report, const ScalarField* field = nullptr,
                           const Progress& progress = {});

}  // namespace isostack

#pragma once

#include <optional>
#include <string>

#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"

namespace isostack {

/// A body as a mesh, or as the label voxels that are not 0, with its surface and what that measures.
struct MeasuredBody {
  TriangleMesh mesh;  ///< of voxels: their faces
  MeshMeasures measures;
  std::optional<LabelVolume> labels;
};

MeasuredBody measured(TriangleMesh mesh);
/// Throws InputError naming `where` when every voxel is 0.
MeasuredBody measured(LabelVolume labels, const std::string& where);

/// The first body against the second.
struct BodyComparison {
  double dice = 0;  ///< on the labels' grid, or one of about 200 voxels along the diagonal round both
  SurfaceDistance distance;
  double diagonal_mm = 0;                          ///< of the box round the second
  double volume_difference_mm3 = 0;                ///< first minus second
  std::optional<double> area_difference_mm2 = {};  ///< first minus second; none with labels, whose faces are stairs
};

/// Throws InputError when two label volumes lie on different grids, or a mesh is empty.
BodyComparison compare(const MeasuredBody& first, const MeasuredBody& second,
                       const SurfaceDistanceOptions& options = {});

}  // namespace isostack

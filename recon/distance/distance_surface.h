#pragma once

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

struct DistanceSurfaceOptions {
  double resolution_mm = 0;  ///< edge of the cells that are visited; 0: the volume's shortest voxel edge
};

/// The surface a distance volume (positive inside, any scale) describes: where its values, linear between voxels along
/// each axis, are zero. Closed, outward, world mm; closed at the volume's outermost voxels where it reaches them.
/// The volume may lie anywhere, also sheared. Throws GeometryError when there is no zero set, the grid is flat, or all
/// of its border is inside, as when the sign is the other way round.
TriangleMesh distance_surface(const Volume<float>& distance_mm, const DistanceSurfaceOptions& options = {},
                              const Progress& progress = {});

}  // namespace isostack

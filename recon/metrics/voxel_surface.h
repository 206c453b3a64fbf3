#pragma once

#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// The faces between voxels that are not 0 and those that are (also at the volume's border), two triangles
/// each, in world mm: the surface a label volume shows, with its stairs. Closed and manifold: where voxels touch along
/// an edge or at a corner only, the surface is drawn apart, so that parts are joined through faces. Its volume is that
/// of the voxels; its area is that of the stairs, up to 1.7 times that of the smooth organ.
TriangleMesh voxel_surface(const LabelVolume& labels);

}  // namespace isostack

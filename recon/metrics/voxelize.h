#pragma once

#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Sets the voxels whose centre lies inside the closed mesh to `label` (even-odd along the grid's
/// first axis); the others keep their value.
void voxelize(const TriangleMesh& mesh, std::uint16_t label, LabelVolume& labels);

}  // namespace isostack

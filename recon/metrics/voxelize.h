#pragma once

#include <Eigen/Core>
#include <optional>

#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Sets the voxels whose centre lies inside the closed mesh to `label` (even-odd along the grid's
/// first axis); the others keep their value.
void voxelize(const TriangleMesh& mesh, std::uint16_t label, LabelVolume& labels);

/// A place (world mm) that a closed mesh with the outside out encloses twice, or less than not at all: parts of it
/// overlap, or one in another is turned wrongly. Looked for along the grid's rows; stretches up to a voxel long are
/// left out. None for a mesh that does not cross itself.
std::optional<Eigen::Vector3d> doubly_enclosed(const TriangleMesh& mesh, const Grid& grid);

}  // namespace isostack

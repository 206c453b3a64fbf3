#pragma once

#include <cstdint>
#include <vector>

#include "recon/distance/mesh_topology.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Distances that are known at some voxels and not yet at others.
struct CarriedDistances {
  std::vector<float> mm;      ///< unsigned; infinite where unknown
  std::vector<int> triangle;  ///< the closest one; -1 where unknown
};

/// Fast marching that carries closest triangles (Breen et al. 2001, §4.2): voxels are taken in order of distance (up to
/// a tenth of a voxel), each hands its triangle to its six neighbours, and a voxel that is taken looks for nearer ones
/// round the triangle it was given. Distances beyond `limit_mm` are left unknown. Nothing passes between voxels of
/// different `side`; the two sides (0, 1) are marched in parallel. An empty `side` is all one side.
void carry_outwards(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid,
                    const std::vector<std::uint8_t>& side, double limit_mm, CarriedDistances& known);

}  // namespace isostack

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recon/distance/mesh_distance.h"
#include "recon/distance/mesh_topology.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Which voxels a mesh encloses.
struct MeshInside {
  std::vector<std::uint8_t> inside;  ///< as the voxels, 0 or 1
  bool closed = true;                ///< every edge has an even number of triangles
  std::vector<std::string> remarks;  ///< what is wrong with the mesh, and what was done about it
};

/// By counting what rows cross where every edge has an even number of triangles, else by winding numbers of the
/// triangles turned alike, or by these for every mesh; see mesh_distance.
MeshInside inside_of(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, MeshSign sign);

}  // namespace isostack

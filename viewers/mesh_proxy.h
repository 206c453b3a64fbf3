#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// A mesh that looks much like another from afar.
struct MeshProxy {
  TriangleMesh mesh;                       ///< with normals where the other has them
  std::vector<std::size_t> source_vertex;  ///< for each vertex one of the other mesh nearby, to take its values from
};

/// About as many triangles as asked for, in time linear in the mesh's: vertices within one cell of a lattice become one
/// (Rossignac & Borrel 1993), at their mean. For drawing while the camera moves; neither closed nor manifold.
MeshProxy mesh_proxy(const TriangleMesh& mesh, std::size_t triangles);

}  // namespace isostack

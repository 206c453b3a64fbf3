#pragma once

#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Throws InputError, naming the mesh and the place, when a closed mesh encloses a place twice (doubly_enclosed) on
/// voxels of a hundredth of its longest side: no signed distance describes it.
void require_no_overlap(const TriangleMesh& mesh);

struct MendedMesh {
  TriangleMesh mesh;                 ///< closed, outward
  std::vector<std::string> remarks;  ///< one sentence each: what was wrong. Empty: the mesh is the given one
};

/// A mesh that is open, crosses itself or disagrees about the outside as the surface of its distance volume, signed by
/// winding numbers, on voxels of a hundredth of its longest side: holes are closed smoothly, overlapping parts united.
/// Throws InputError, naming the mesh, when it encloses nothing.
MendedMesh mended_mesh(const TriangleMesh& mesh, const Progress& progress = {});

}  // namespace isostack

#pragma once

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// The phantom's true surface in world LPS mm, by flying edges on a lattice of the given spacing; closed, outwards.
TriangleMesh phantom_surface(double lattice_mm);

}  // namespace isostack

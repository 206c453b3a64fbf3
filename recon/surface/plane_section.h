#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Where the plane of `pose` cuts a closed, consistently oriented mesh: closed contours in slice mm, the inside to
/// the left, depths set by nesting. A vertex in the plane counts as above it (on the side of its normal). Loops of
/// fewer than three points are left out, and so are open ends where the mesh is not closed.
std::vector<Contour> plane_section(const TriangleMesh& mesh, const SlicePose& pose);

}  // namespace isostack

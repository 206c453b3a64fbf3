#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// The lines in which a plane cuts a mesh, to be drawn as closed curves, slice mm: where the mesh is open, a line goes
/// there and back.
std::vector<Contour> cut_lines(const TriangleMesh& mesh, const SlicePose& pose);

}  // namespace isostack

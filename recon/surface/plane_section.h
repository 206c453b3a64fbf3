#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Where a plane cuts a mesh, slice mm.
struct SectionLines {
  std::vector<Contour> closed;                     ///< the inside to the left, depths set by nesting
  std::vector<std::vector<Eigen::Vector2d>> open;  ///< from edge to edge of a mesh that is not closed
};

/// The lines in which the plane of `pose` cuts a consistently oriented mesh. A vertex in the plane counts as above it
/// (on the side of its normal). Loops of fewer than three points are left out.
SectionLines section_lines(const TriangleMesh& mesh, const SlicePose& pose);

/// The closed ones: all of them where the mesh is closed.
std::vector<Contour> plane_section(const TriangleMesh& mesh, const SlicePose& pose);

}  // namespace isostack

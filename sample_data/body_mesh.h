#pragma once

#include <Eigen/Geometry>

#include "recon/geometry/triangle_mesh.h"
#include "sample_data/shapes.h"

namespace isostack {

/// The surface of a body within a box, in cells of this edge: vertices lie on it. A line along -x through the middle of
/// the box must meet it.
TriangleMesh mesh_of(const Body& body, const Eigen::AlignedBox3d& bounds_mm, double cell_mm);

}  // namespace isostack

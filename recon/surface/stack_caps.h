#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// The field that beyond each plane has the value at the point's projection onto it: the cross-section
/// there goes on unchanged, as voxels do. Planes are positive within.
ScalarField extruded_beyond(const ScalarField& field, const std::vector<Eigen::Hyperplane<double, 3>>& planes);

/// The part of the mesh where every plane is positive or zero. Triangles are split at the planes;
/// vertices there are shared, so the cut is one chain of boundary edges per loop. Normals are interpolated.
TriangleMesh clipped(TriangleMesh mesh, const std::vector<Eigen::Hyperplane<double, 3>>& planes);

}  // namespace isostack

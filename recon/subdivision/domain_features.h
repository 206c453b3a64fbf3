#pragma once

#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// A corner of a surface and where on the domain it is to be.
struct PulledVertex {
  int vertex = 0;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// The surface drawn so that some corners are at given places: the domain is moved along with them in small steps, its
/// triangles relaxed after each, none turned over. Throws InputError when corners cannot come past each other.
DomainMesh pulled(const TriangleMesh& surface, const DomainMesh& drawn, const std::vector<PulledVertex>& vertices);

}  // namespace isostack

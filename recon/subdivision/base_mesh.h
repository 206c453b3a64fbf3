#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/subdivision/surface_domain.h"

namespace isostack {

struct BaseMeshOptions {
  int vertices = 12;               ///< at least, on the sphere; more where asked-for points leave wide gaps
  double widest_gap_degrees = 55;  ///< from any place of the sphere to the nearest vertex
};

/// A level-0 mesh on the sphere: the Delaunay triangles of the points asked for, first and in their order, and others
/// that fill the gaps evenly; an icosahedron when none are asked for. Its dual cells are convex.
DomainMesh sphere_base(const std::vector<Eigen::Vector3d>& points, const BaseMeshOptions& options = {});

/// A level-0 mesh on a torus: `around[0]` × `around[1]` vertices (each at least 4), equilateral triangles, so that the
/// periods are around[0] × (1, 0) and around[1] × (1/2, √3/2). Its dual cells are regular hexagons.
DomainMesh torus_base(const Eigen::Vector2i& around);

/// Dual vertices: of each triangle the point as far from all its corners, which is as near as any vertex.
std::vector<Eigen::Vector3d> dual_points(const DomainMesh& base);

}  // namespace isostack

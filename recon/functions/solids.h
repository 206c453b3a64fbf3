#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "recon/functions/solid_function.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Exact signed distance to what contours enclose (even-odd), mm in their slice; of a polygon, too. Points are 2 × M.
/// Throws InputError when there is no contour.
SolidFunction figure_solid(std::vector<Contour> contours);

/// Exact signed distance to a closed mesh whose triangles face outwards, by the nearest triangle; which side is told
/// by the angle-weighted normal of its nearest face, edge or corner (Bærentzen & Aanæs 2005). Points are 3 × M, world
/// mm. Throws InputError when the mesh has no triangles.
SolidFunction mesh_solid(const TriangleMesh& mesh);

/// Signed distances on a grid, positive inside, linear between its nodes. Outside the grid: the rim's value less the
/// distance to the grid. Points are 3 × M, world mm. Throws InputError when the grid has fewer than two nodes along an
/// axis.
SolidFunction volume_solid(Volume<float> distances_mm);

/// Half-axes and roundness of a superellipsoid in its own axes.
struct Superellipsoid {
  Eigen::Vector3d half_axes_mm = Eigen::Vector3d::Ones();
  double south_north = 1, east_west = 1;  ///< exponents ε1, ε2: 1 round, towards 0 a box, 2 an octahedron
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();
};

/// (1 − ((|x/a|^(2/ε2) + |y/b|^(2/ε2))^(ε2/ε1) + |z/c|^(2/ε1))^(ε1/2)) × the shortest half-axis: 0 on the surface, a
/// distance only of balls. Points are 3 × M, world mm. Throws InputError for sizes or exponents not above 0.
SolidFunction superellipsoid_solid(const Superellipsoid& shape);

}  // namespace isostack

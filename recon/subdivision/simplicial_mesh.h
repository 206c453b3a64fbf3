#pragma once

#include <Eigen/Core>

namespace isostack {

/// Simplices joined at their vertices: triangles of a body's surface (n = 3, 3 vertices each), triangles of the
/// interpolator of figures in (x, y, t), tetrahedra of the interpolator of bodies in (x, y, z, t) (Ohbuchi, Kokojima &
/// Takahashi 2001, Section 2: S-meshes and I-meshes). All coordinates in mm; t is the last one.
struct SimplicialMesh {
  Eigen::MatrixXd vertices;   ///< one column per vertex
  Eigen::MatrixXi simplices;  ///< one column per simplex: its vertices

  Eigen::Index dimension() const { return vertices.rows(); }
  Eigen::Index vertex_count() const { return vertices.cols(); }
  Eigen::Index simplex_count() const { return simplices.cols(); }
};

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace isostack {

/// One step finer: every edge gets a vertex in its middle, every triangle becomes four (topologically Loop's rule,
/// Ohbuchi et al. 2001, Figure 6), every tetrahedron eight (Moore's symmetric rule, Figure 7).
struct SimplexSubdivision {
  Eigen::MatrixXi simplices;  ///< of the finer mesh
  std::vector<std::array<int, 2>>
      edges;  ///< of the coarse mesh, (low, high), sorted; vertex `coarse count + i` halves edge i
};

/// Of triangles (3 rows) or tetrahedra (4 rows); orientation is kept. A tetrahedron's inner octahedron is cut along the
/// diagonal that Moore's rule takes by the order of its vertices, so neighbours always agree on their common face.
SimplexSubdivision subdivide(const Eigen::MatrixXi& simplices, Eigen::Index vertex_count);

/// The finer mesh's vertices, the new ones half-way (the matrix P of eq. 4): one column per vertex.
Eigen::MatrixXd midpoint_refined(const Eigen::MatrixXd& vertices, const SimplexSubdivision& subdivision);

}  // namespace isostack

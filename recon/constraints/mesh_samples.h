#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Throws InputError, naming the mesh, unless it is closed, consistently oriented with triangles that face outwards,
/// and not empty.
void require_closed(const TriangleMesh& mesh);

/// A point of a closed surface kept as a boundary constraint.
struct MeshSample {
  Eigen::Vector3d point_mm;
  Eigen::Vector3d outward;  ///< unit normal
};

/// The vertices with their normals: the mesh's, or the mean of their triangles' weighted by angle. Vertices no triangle
/// uses are left out. Throws like require_closed.
std::vector<MeshSample> vertex_samples(const TriangleMesh& mesh);

struct MeshSamplingOptions {
  std::size_t max_samples = 3333;
  double min_spacing_mm = 0;        ///< samples that look the same way are no nearer
  std::size_t least_per_part = 12;  ///< about as many for every connected part, however small, while half suffices
  std::uint64_t seed = 1;
};

/// Points spread evenly over the surface (Poisson discs): as many as fit at the wanted spacing, or max_samples at the
/// smallest spacing at which no more fit; then hardly a place of the surface is farther than the spacing from one.
/// The two sides of a thin sheet do not see each other. Normals are the triangles'. Throws like require_closed.
std::vector<MeshSample> spread_samples(const TriangleMesh& mesh, const MeshSamplingOptions& options);

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Distances in mm over samples drawn uniformly by area from both surfaces.
struct SurfaceDistance {
  double mean_mm = 0;          ///< mean of the two directions' means
  double percentile95_mm = 0;  ///< larger of the two directions' 95 % quantiles
  double largest_mm = 0;       ///< larger of the two directions' largest (Hausdorff)
};

struct SurfaceDistanceOptions {
  std::size_t samples = 25'000;  ///< drawn from each surface
  std::uint64_t seed = 1;
};

/// Unsigned distance of each point to the mesh (point to triangle). Throws InputError on an empty mesh.
std::vector<double> distances_to_mesh_mm(const std::vector<Eigen::Vector3d>& points_mm, const TriangleMesh& mesh);

/// A point on a surface and the triangle it lies on.
struct SurfacePoint {
  Eigen::Vector3d point_mm;
  std::size_t triangle;
};

/// Points uniformly by area. Throws InputError on an empty mesh.
std::vector<SurfacePoint> sample_triangles(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

/// The same without the triangles. Throws InputError on an empty mesh.
std::vector<Eigen::Vector3d> sample_surface(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b,
                                 const SurfaceDistanceOptions& options = {});

}  // namespace isostack

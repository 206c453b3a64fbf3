#include "recon/metrics/mesh_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/metrics/quantile.h"

namespace isostack {

MeshQuality measure_quality(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw InputError(mesh.name.empty() ? "mesh" : mesh.name, "the mesh has no triangles", "give a surface");
  std::vector<double> lengths, smallest_angles;
  MeshQuality quality;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    double smallest = 180;
    for (int corner = 0; corner < 3; ++corner) {
      const int a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
      const Eigen::Vector3d& from = mesh.vertices_mm[static_cast<std::size_t>(a)];
      const Eigen::Vector3d to_b = mesh.vertices_mm[static_cast<std::size_t>(b)] - from,
                            to_c = mesh.vertices_mm[static_cast<std::size_t>(c)] - from;
      const double angle = std::atan2(to_b.cross(to_c).norm(), to_b.dot(to_c)) * 180 / std::numbers::pi;
      smallest = std::min(smallest, angle);
      quality.corners_below_20_deg += angle < 20 ? 1 : 0;
      lengths.push_back(to_b.norm());  // an inner edge counts twice, once from each side
    }
    smallest_angles.push_back(smallest);
  }
  quality.shortest_edge_mm = quantile(lengths, 0);
  quality.edge_percentile5_mm = quantile(lengths, 0.05);
  quality.median_edge_mm = quantile(lengths, 0.5);
  quality.edge_percentile95_mm = quantile(lengths, 0.95);
  quality.longest_edge_mm = quantile(lengths, 1);
  quality.smallest_angle_deg = quantile(smallest_angles, 0);
  quality.mean_smallest_angle_deg = mean(smallest_angles);
  return quality;
}

}  // namespace isostack

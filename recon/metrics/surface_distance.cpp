#include "recon/metrics/surface_distance.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/metrics/closest_point.h"
#include "recon/metrics/point_triangle.h"
#include "recon/metrics/quantile.h"

namespace isostack {

namespace {

Triangle corners_of(const TriangleMesh& mesh, int triangle) {
  const Eigen::Vector3i& t = mesh.triangles[static_cast<std::size_t>(triangle)];
  const auto& v = mesh.vertices_mm;
  return {v[static_cast<std::size_t>(t[0])], v[static_cast<std::size_t>(t[1])], v[static_cast<std::size_t>(t[2])]};
}

void require_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw InputError(mesh.name.empty() ? "mesh" : mesh.name, "the mesh has no triangles", "give a surface");
}

}  // namespace

std::vector<double> distances_to_mesh_mm(const std::vector<Eigen::Vector3d>& points_mm, const TriangleMesh& mesh) {
  const ClosestPoint closest(mesh);
  std::vector<double> distances(points_mm.size());
  tbb::parallel_for(std::size_t{0}, points_mm.size(),
                    [&](std::size_t i) { distances[i] = (closest.on_mesh(points_mm[i]) - points_mm[i]).norm(); });
  return distances;
}

std::vector<SurfacePoint> sample_triangles(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  require_triangles(mesh);
  std::vector<double> cumulative_area(mesh.triangles.size());
  double total = 0;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    const Triangle t = corners_of(mesh, static_cast<int>(n));
    cumulative_area[n] = total += (t[1] - t[0]).cross(t[2] - t[0]).norm();
  }
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<SurfacePoint> samples(count);
  for (SurfacePoint& sample : samples) {
    const auto chosen = std::lower_bound(cumulative_area.begin(), cumulative_area.end() - 1, uniform(random) * total);
    sample.triangle = static_cast<std::size_t>(chosen - cumulative_area.begin());
    const Triangle t = corners_of(mesh, static_cast<int>(sample.triangle));
    double u = uniform(random), v = uniform(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    sample.point_mm = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  }
  return samples;
}

std::vector<Eigen::Vector3d> sample_surface(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  std::vector<Eigen::Vector3d> points;
  for (const SurfacePoint& sample : sample_triangles(mesh, count, seed)) points.push_back(sample.point_mm);
  return points;
}

SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b, const SurfaceDistanceOptions& options) {
  const auto a_to_b = distances_to_mesh_mm(sample_surface(a, options.samples, options.seed), b);
  const auto b_to_a = distances_to_mesh_mm(sample_surface(b, options.samples, options.seed + 1), a);
  SurfaceDistance result;
  result.mean_mm = (mean(a_to_b) + mean(b_to_a)) / 2;
  result.percentile95_mm = std::max(quantile(a_to_b, 0.95), quantile(b_to_a, 0.95));
  result.largest_mm = std::max(quantile(a_to_b, 1.0), quantile(b_to_a, 1.0));
  return result;
}

}  // namespace isostack

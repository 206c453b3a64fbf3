#include "recon/metrics/mesh_curvature.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstddef>

#include "recon/metrics/quantile.h"

namespace isostack {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const std::vector<Eigen::Vector3d>& values, const Eigen::Vector3i& triangle) {
  return {values[static_cast<std::size_t>(triangle[0])], values[static_cast<std::size_t>(triangle[1])],
          values[static_cast<std::size_t>(triangle[2])]};
}

std::vector<Eigen::Vector3d> normals_of(const TriangleMesh& mesh) {
  if (mesh.normals.size() == mesh.vertices_mm.size()) return mesh.normals;
  std::vector<Eigen::Vector3d> normals(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Corners p = corners_of(mesh.vertices_mm, triangle);
    const Eigen::Vector3d twice_area = (p[1] - p[0]).cross(p[2] - p[0]);
    for (const int corner : triangle) normals[static_cast<std::size_t>(corner)] += twice_area;
  }
  for (Eigen::Vector3d& normal : normals) normal.normalize();
  return normals;
}

/// Half the trace of the symmetric map from the triangle's edges to the differences of the normals along them.
double mean_curvature(const Corners& p, const Corners& n) {
  const Eigen::Vector3d u = (p[1] - p[0]).normalized();
  const Eigen::Vector3d v = (p[1] - p[0]).cross(p[2] - p[0]).cross(u).normalized();
  Eigen::Matrix<double, 6, 3> edges;  // unknowns: uu, uv, vv
  Eigen::Matrix<double, 6, 1> turns;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d edge = p[(i + 2) % 3] - p[(i + 1) % 3], turn = n[(i + 2) % 3] - n[(i + 1) % 3];
    const auto row = static_cast<Eigen::Index>(2 * i);
    edges.row(row) << edge.dot(u), edge.dot(v), 0;
    edges.row(row + 1) << 0, edge.dot(u), edge.dot(v);
    turns.segment<2>(row) << turn.dot(u), turn.dot(v);
  }
  const Eigen::Vector3d map = edges.colPivHouseholderQr().solve(turns);
  return (map[0] + map[2]) / 2;
}

}  // namespace

std::vector<double> mean_curvatures_per_mm(const TriangleMesh& mesh) {
  const std::vector<Eigen::Vector3d> normals = normals_of(mesh);
  std::vector<double> sums(mesh.vertices_mm.size(), 0.0), areas(mesh.vertices_mm.size(), 0.0);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Corners p = corners_of(mesh.vertices_mm, triangle);
    const double twice_area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
    const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    if (!(twice_area > 1e-6 * longest * longest)) continue;  // a needle says nothing across its direction
    const double curvature = mean_curvature(p, corners_of(normals, triangle));
    for (const int corner : triangle) {
      sums[static_cast<std::size_t>(corner)] += twice_area * curvature;
      areas[static_cast<std::size_t>(corner)] += twice_area;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = areas[i] > 0 ? sums[i] / areas[i] : 0;
  return sums;
}

CurvatureRange mean_curvature_range_per_mm(const TriangleMesh& mesh) {
  std::vector<double> curvatures = mean_curvatures_per_mm(mesh);
  if (curvatures.empty()) return {};
  const auto [lowest, highest] = std::minmax_element(curvatures.begin(), curvatures.end());
  CurvatureRange range{.lowest = *lowest, .highest = *highest};
  range.percentile1 = quantile(curvatures, 0.01);
  range.percentile99 = quantile(curvatures, 0.99);
  return range;
}

}  // namespace isostack

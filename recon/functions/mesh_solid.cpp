#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <unsupported/Eigen/BVH>
#include <utility>
#include <vector>

#include "recon/functions/over_points.h"
#include "recon/functions/solids.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/point_triangle.h"

namespace isostack {

namespace {

using Box = Eigen::AlignedBox3d;

/// A triangle with the normals that tell its inner side: of the face, and the sums over all faces at each edge (from
/// corner i to i + 1) and, weighted by angle, at each corner.
struct SidedTriangle {
  Triangle corners;
  Eigen::Vector3d face;
  std::array<Eigen::Vector3d, 3> edges, vertices;
};

/// Whether p is the inner side at the triangle's point nearest to it.
bool is_inner_side(const SidedTriangle& triangle, const Eigen::Vector3d& p, const Eigen::Vector3d& nearest) {
  constexpr double on_it = 1e-9;  // shares of the triangle's corners in a point on an edge or corner
  const Triangle& t = triangle.corners;
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  std::array<bool, 3> is_at{};  // the corners that have a share in the point
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    is_at[i] = (b - a).cross(nearest - a).dot(normal) > on_it * normal.squaredNorm();
    count += is_at[i] ? 1 : 0;
  }
  Eigen::Vector3d outwards = triangle.face;
  for (std::size_t i = 0; i < 3; ++i) {
    if (count == 2 && !is_at[(i + 2) % 3]) outwards = triangle.edges[i];
    if (count == 1 && is_at[i]) outwards = triangle.vertices[i];
  }
  return (p - nearest).dot(outwards) <= 0;
}

std::vector<SidedTriangle> sided_triangles(const TriangleMesh& mesh) {
  std::vector<SidedTriangle> result;
  std::vector<Eigen::Vector3d> at_vertex(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  std::map<std::pair<int, int>, Eigen::Vector3d> at_edge;
  const auto edge = [](int a, int b) { return std::pair{std::min(a, b), std::max(a, b)}; };
  for (const Eigen::Vector3i& t : mesh.triangles) {
    SidedTriangle sided;
    for (int i = 0; i < 3; ++i)
      sided.corners[static_cast<std::size_t>(i)] = mesh.vertices_mm[static_cast<std::size_t>(t[i])];
    const Triangle& c = sided.corners;
    sided.face = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    for (int i = 0; i < 3; ++i) {
      const auto here = static_cast<std::size_t>(i), next = (here + 1) % 3, last = (here + 2) % 3;
      const Eigen::Vector3d u = c[next] - c[here], v = c[last] - c[here];
      at_vertex[static_cast<std::size_t>(t[i])] += std::atan2(u.cross(v).norm(), u.dot(v)) * sided.face;
      at_edge.try_emplace(edge(t[i], t[(i + 1) % 3]), Eigen::Vector3d::Zero()).first->second += sided.face;
    }
    result.push_back(sided);
  }
  for (std::size_t n = 0; n < result.size(); ++n)
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3i& t = mesh.triangles[n];
      result[n].vertices[static_cast<std::size_t>(i)] = at_vertex[static_cast<std::size_t>(t[i])];
      result[n].edges[static_cast<std::size_t>(i)] = at_edge.at(edge(t[i], t[(i + 1) % 3]));
    }
  return result;
}

// What Eigen's tree asks for. NOLINTBEGIN(readability-identifier-naming): Eigen calls them so.
struct Nearest {
  using Scalar = double;
  const std::vector<SidedTriangle>& triangles;
  const Eigen::Vector3d& point;
  double best = std::numeric_limits<double>::infinity();
  Eigen::Vector3d closest = Eigen::Vector3d::Zero();
  std::size_t triangle = 0;

  double minimumOnVolume(const Box& box) const { return box.squaredExteriorDistance(point); }
  double minimumOnObject(int number) {
    const auto n = static_cast<std::size_t>(number);
    const Eigen::Vector3d candidate = closest_point_on_triangle(triangles[n].corners, point);
    const double squared = (candidate - point).squaredNorm();
    if (squared < best) best = squared, closest = candidate, triangle = n;
    return squared;
  }
};
// NOLINTEND(readability-identifier-naming)

class MeshDistance {
 public:
  explicit MeshDistance(const TriangleMesh& mesh) : triangles_(sided_triangles(mesh)) {
    std::vector<Box> boxes(triangles_.size());
    for (std::size_t n = 0; n < boxes.size(); ++n)
      for (const Eigen::Vector3d& p : triangles_[n].corners) boxes[n].extend(p);
    std::vector<int> numbers(boxes.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    boxes_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  }

  double at(const Eigen::Vector3d& point) const {
    Nearest query{triangles_, point};
    Eigen::BVMinimize(boxes_, query);
    const double mm = (query.closest - point).norm();
    return is_inner_side(triangles_[query.triangle], point, query.closest) ? mm : -mm;
  }

 private:
  std::vector<SidedTriangle> triangles_;
  Eigen::KdBVH<double, 3, int> boxes_;
};

}  // namespace

SolidFunction mesh_solid(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw InputError(mesh.name.empty() ? "mesh" : mesh.name, "the mesh has no triangles", "give a surface");
  const auto distance = std::make_shared<const MeshDistance>(mesh);
  return [distance](const Eigen::MatrixXd& points) {
    return over_points(points.cols(), [&](Eigen::Index i) { return distance->at(points.col(i)); });
  };
}

}  // namespace isostack

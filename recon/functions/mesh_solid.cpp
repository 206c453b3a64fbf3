#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "recon/distance/mesh_topology.h"
#include "recon/functions/over_points.h"
#include "recon/functions/solids.h"
#include "recon/metrics/closest_point.h"

namespace isostack {

namespace {

using Eigen::Vector3d;

/// Which side of a mesh points are on, by the normals of its faces, and sums of these at each edge and, weighted by
/// angle, at each vertex.
class MeshSides {
 public:
  explicit MeshSides(const TriangleMesh& mesh)
      : mesh_(mesh), at_sides_(3 * mesh.triangles.size()), at_vertices_(mesh.vertices_mm.size(), Vector3d::Zero()) {
    for (int n = 0; n < static_cast<int>(mesh.triangles.size()); ++n) {
      const Triangle t = triangle_of(mesh, n);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d u = t[(i + 1) % 3] - t[i], v = t[(i + 2) % 3] - t[i];
        const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
        at_vertices_[static_cast<std::size_t>(corner(mesh, n, static_cast<int>(i)))] += angle * face(n);
        at_sides_[3 * static_cast<std::size_t>(n) + i] = face(n);  // of a side of no length: it is on no edge
      }
    }
    const MeshTopology topology = topology_of(mesh);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      Vector3d sum = Vector3d::Zero();
      for (const int side : topology.sides_of_edge[static_cast<int>(e)]) sum += face(side / 3);
      for (const int side : topology.sides_of_edge[static_cast<int>(e)])
        at_sides_[static_cast<std::size_t>(side)] = sum;
    }
  }

  /// Whether p is on the inner side at the point of the mesh nearest to it.
  bool is_inner(const Vector3d& p, const ClosestPoint::Place& nearest) const {
    constexpr double on_it = 1e-9;  // shares of the triangle's corners in a point on an edge or corner
    const Triangle t = triangle_of(mesh_, nearest.triangle);
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    std::array<bool, 3> is_at{};  // the corners that have a share in the point
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
      is_at[i] = (b - a).cross(nearest.point_mm - a).dot(normal) > on_it * normal.squaredNorm();
      count += is_at[i] ? 1 : 0;
    }
    Vector3d outwards = face(nearest.triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (count == 2 && !is_at[(i + 2) % 3]) outwards = at_sides_[3 * static_cast<std::size_t>(nearest.triangle) + i];
      if (count == 1 && is_at[i])
        outwards = at_vertices_[static_cast<std::size_t>(corner(mesh_, nearest.triangle, static_cast<int>(i)))];
    }
    return (p - nearest.point_mm).dot(outwards) <= 0;
  }

 private:
  Vector3d face(int triangle) const {
    const Triangle t = triangle_of(mesh_, triangle);
    return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  }

  TriangleMesh mesh_;
  std::vector<Vector3d> at_sides_;  ///< of each triangle's, from corner i to i + 1
  std::vector<Vector3d> at_vertices_;
};

}  // namespace

SolidFunction mesh_solid(const TriangleMesh& mesh) {
  struct Body {
    ClosestPoint surface;
    MeshSides sides;
  };
  const auto body = std::make_shared<const Body>(Body{ClosestPoint(mesh), MeshSides(mesh)});
  return [body](const Eigen::MatrixXd& points) {
    return over_points(points.cols(), [&](Eigen::Index i) {
      const Vector3d point = points.col(i);
      const ClosestPoint::Place nearest = body->surface.nearest(point);
      const double mm = (nearest.point_mm - point).norm();
      return body->sides.is_inner(point, nearest) ? mm : -mm;
    });
  };
}

}  // namespace isostack

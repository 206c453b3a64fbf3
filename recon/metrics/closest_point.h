#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Answers where a mesh is nearest to a point, by a tree of boxes over a copy of its triangles.
/// May be asked from several threads at once.
class ClosestPoint {
 public:
  /// Throws InputError on an empty mesh.
  explicit ClosestPoint(const TriangleMesh& mesh);

  struct Place {
    Eigen::Vector3d point_mm;
    int triangle;
  };
  Place nearest(const Eigen::Vector3d& point_mm) const;
  Eigen::Vector3d on_mesh(const Eigen::Vector3d& point_mm) const { return nearest(point_mm).point_mm; }
  /// On the triangles whose outward side looks the way `direction` does; none when there is no such triangle.
  std::optional<Eigen::Vector3d> on_side_facing(const Eigen::Vector3d& direction,
                                                const Eigen::Vector3d& point_mm) const;
  /// Whether some triangle is this near.
  bool is_within(double distance_mm, const Eigen::Vector3d& point_mm) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace isostack

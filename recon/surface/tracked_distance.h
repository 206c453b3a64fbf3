#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recon/metrics/closest_point.h"
#include "recon/metrics/point_triangle.h"
#include "recon/surface/editable_mesh.h"

namespace isostack {

/// Keeps a mesh that is being simplified within a distance of what it was: knows for every triangle which points of
/// the given surface it stands for.
class TrackedDistance {
 public:
  /// Both must outlive this; `mesh` is `input` before any change.
  TrackedDistance(const TriangleMesh& input, const EditableMesh& mesh, double limit_mm);

  /// Whether the triangles round the collapsed edge would stay within the limit. Keeps what it found for commit().
  bool allows(int keep, int gone, const Eigen::Vector3d& there);
  /// To be called right after the collapse that was last allowed.
  void commit();

 private:
  struct NewTriangle {
    int number;
    Triangle corners;
  };
  bool is_near_input(const Eigen::Vector3d& there) const;
  bool assign_points(int keep, int gone);

  const EditableMesh& mesh_;
  double limit_mm_;
  ClosestPoint input_;
  std::vector<Eigen::Vector3d> points_mm_;   ///< corners and centres of the given triangles
  std::vector<std::vector<int>> points_of_;  ///< for each triangle
  std::vector<NewTriangle> changed_;         ///< triangles after the collapse in question
  std::vector<std::vector<int>> assigned_;   ///< their points
  std::array<int, 2> removed_{-1, -1};
};

}  // namespace isostack

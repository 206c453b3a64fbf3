#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// How far a surface through these slices may reach.
struct StackBounds {
  Eigen::AlignedBox3d box;                                ///< round the contours, a quarter of the diagonal wider
  std::vector<Eigen::Hyperplane<double, 3>> half_spaces;  ///< ends of a parallel stack; positive within
  bool open_end = false;                                  ///< the organ goes on beyond an outermost slice
};

/// Beyond the outermost slices of a parallel stack the surface may close by itself within one and
/// a half gaps (the method's round ends). Where f is still positive there, the organ is cut by
/// the stack's end and the surface stops half a gap beyond the slice, as voxels do.
/// `values` evaluates f at 3 × M points; poses must not be empty.
StackBounds stack_bounds(const std::vector<SlicePose>& poses, const std::vector<Eigen::Vector3d>& contour_points_mm,
                         const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& values);

}  // namespace isostack

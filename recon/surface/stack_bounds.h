#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// How a surface ends beyond the outermost slices of a parallel stack.
enum class Caps {
  round,  ///< it closes by itself within one and a half gaps; an organ that goes on there is cut flat
  flat,   ///< in planes half a gap outside the outermost slices with contours, as voxels do
  open    ///< at the outermost slices with contours, without a lid
};

/// How far a surface through these slices may reach.
struct StackBounds {
  Eigen::AlignedBox3d box;                                ///< round the contours, a quarter of the diagonal wider
  std::vector<Eigen::Hyperplane<double, 3>> half_spaces;  ///< ends of a parallel stack; positive within
  bool open_end = false;                                  ///< the organ goes on beyond an outermost slice
  std::vector<Eigen::Hyperplane<double, 3>> ends;  ///< flat, open: outermost slices with contours; positive within
};

/// Beyond the outermost slices of a parallel stack the surface may close by itself within one and
/// a half gaps (the method's round ends). Where f is still positive there, the organ is cut by
/// the stack's end and the surface stops half a gap beyond the slice, as voxels do.
/// Flat and open caps do not ask f. `values` evaluates f at 3 × M points; poses must not be empty.
/// Throws GeometryError for flat or open caps unless all slices are parallel and in two planes at least.
StackBounds stack_bounds(const std::vector<SlicePose>& poses, const std::vector<Eigen::Vector3d>& contour_points_mm,
                         const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& values, Caps caps = Caps::round);

}  // namespace isostack

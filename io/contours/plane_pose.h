#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// The pose of a plane of which a file says no more than its unit normal and how far it is from the world's origin
/// along that. Its origin is its point nearest to the world's; its x axis is world x, or y where the normal is within
/// 26° of x, projected onto it; spacing 1 mm.
inline SlicePose pose_of_plane(const Eigen::Vector3d& normal, double distance_mm) {
  const Eigen::Vector3d across = std::abs(normal.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  SlicePose pose;
  pose.origin_mm = distance_mm * normal;
  pose.x_axis = (across - normal.dot(across) * normal).normalized();
  pose.y_axis = normal.cross(pose.x_axis);
  return pose;
}

}  // namespace isostack

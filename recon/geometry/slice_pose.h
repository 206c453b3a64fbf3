#pragma once

#include <Eigen/Geometry>
#include <string>

namespace isostack {

/// Where a slice lies in the patient. World is DICOM patient space (LPS, mm).
///
/// Three frames: *pixel* (x = column index, y = row index, centres at integers),
/// *slice* (mm from the centre of pixel (0, 0) along x_axis and y_axis) and *world*.
struct SlicePose {
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();   ///< world position of the centre of pixel (0, 0)
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();     ///< unit direction of growing column index
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();     ///< unit direction of growing row index
  Eigen::Vector2d spacing_mm = Eigen::Vector2d::Ones();  ///< pixel distance along x_axis and y_axis

  Eigen::Vector3d normal() const { return x_axis.cross(y_axis); }

  Eigen::Vector3d slice_to_world(const Eigen::Vector2d& point_in_slice_mm) const;
  /// Orthogonal projection onto the plane, in slice coordinates.
  Eigen::Vector2d world_to_slice(const Eigen::Vector3d& point_in_world_mm) const;
  Eigen::Vector2d pixel_to_slice(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d slice_to_pixel(const Eigen::Vector2d& point_in_slice_mm) const;
  Eigen::Vector3d pixel_to_world(const Eigen::Vector2d& pixel) const;

  /// Distance to the plane in mm, positive on the side of normal().
  double signed_distance_mm(const Eigen::Vector3d& point_in_world_mm) const;
};

/// Throws GeometryError naming `where` unless the axes are orthonormal (to 1e-3),
/// the spacing is positive and every number is finite and below 1e9 mm. Axes are re-orthonormalised.
SlicePose checked_pose(SlicePose pose, const std::string& where);

/// True when the two planes' normals differ by less than `angle_rad`, ignoring their sign.
bool are_parallel(const SlicePose& a, const SlicePose& b, double angle_rad = 1e-3);

/// True when the planes are parallel and b's origin is less than `distance_mm` from a's plane.
bool in_one_plane(const SlicePose& a, const SlicePose& b, double distance_mm);

}  // namespace isostack

#include "recon/geometry/slice_pose.h"

#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

Eigen::Vector3d SlicePose::slice_to_world(const Eigen::Vector2d& point_in_slice_mm) const {
  return origin_mm + point_in_slice_mm.x() * x_axis + point_in_slice_mm.y() * y_axis;
}

Eigen::Vector2d SlicePose::world_to_slice(const Eigen::Vector3d& point_in_world_mm) const {
  const Eigen::Vector3d offset_mm = point_in_world_mm - origin_mm;
  return {offset_mm.dot(x_axis), offset_mm.dot(y_axis)};
}

Eigen::Vector2d SlicePose::pixel_to_slice(const Eigen::Vector2d& pixel) const { return pixel.cwiseProduct(spacing_mm); }

Eigen::Vector2d SlicePose::slice_to_pixel(const Eigen::Vector2d& point_in_slice_mm) const {
  return point_in_slice_mm.cwiseQuotient(spacing_mm);
}

Eigen::Vector3d SlicePose::pixel_to_world(const Eigen::Vector2d& pixel) const {
  return slice_to_world(pixel_to_slice(pixel));
}

double SlicePose::signed_distance_mm(const Eigen::Vector3d& point_in_world_mm) const {
  return (point_in_world_mm - origin_mm).dot(normal());
}

SlicePose checked_pose(SlicePose pose, const std::string& where) {
  const bool finite =
      pose.origin_mm.allFinite() && pose.x_axis.allFinite() && pose.y_axis.allFinite() && pose.spacing_mm.allFinite();
  if (!finite)
    throw GeometryError(where, "the position or orientation has a value that is not a number", "repair the header");
  constexpr double farthest_mm = 1e9;  // distances and their squares stay far from overflow
  if (pose.origin_mm.cwiseAbs().maxCoeff() > farthest_mm || pose.spacing_mm.maxCoeff() > farthest_mm)
    throw GeometryError(where, "the position or pixel spacing is beyond 1000 km", "repair the header");
  if (!(pose.spacing_mm.minCoeff() > 0))
    throw GeometryError(where, "the pixel spacing is not positive", "repair the header or give --spacing");
  const double skew = std::abs(pose.x_axis.dot(pose.y_axis));
  const double stretch = std::max(std::abs(pose.x_axis.norm() - 1), std::abs(pose.y_axis.norm() - 1));
  if (skew > 1e-3 || stretch > 1e-3)
    throw GeometryError(where, "the row and column directions are not perpendicular unit vectors",
                        "repair the orientation in the header");
  pose.x_axis.normalize();
  pose.y_axis = (pose.y_axis - pose.x_axis * pose.x_axis.dot(pose.y_axis)).normalized();
  return pose;
}

bool are_parallel(const SlicePose& a, const SlicePose& b, double angle_rad) {
  return a.normal().cross(b.normal()).norm() < std::sin(angle_rad);
}

bool in_one_plane(const SlicePose& a, const SlicePose& b, double distance_mm) {
  return are_parallel(a, b) && std::abs(a.signed_distance_mm(b.origin_mm)) < distance_mm;
}

}  // namespace isostack

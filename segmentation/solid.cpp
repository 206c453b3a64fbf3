#include "segmentation/solid.h"

#include <algorithm>

namespace isostack {

double signed_distance_mm(const Solid& solid, const Eigen::Vector3d& point_in_world_mm) {
  const Eigen::Vector3d p = point_in_world_mm - solid.centre_mm;
  if (solid.shape == Solid::Shape::box) {
    const Eigen::Vector3d beyond = p.cwiseAbs() - solid.half_size_mm;
    return -(beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff()));
  }
  const Eigen::Vector3d scaled = p.cwiseQuotient(solid.half_size_mm);
  const double height = scaled.norm();
  const double slope = scaled.cwiseQuotient(solid.half_size_mm).norm();
  return slope > 0 ? height * (1 - height) / slope : solid.half_size_mm.minCoeff();
}

Image<float> signed_distance_mm(const Solid& solid, const SlicePose& pose, const Eigen::Vector2i& size_pixels) {
  Image<float> distance(size_pixels.y(), size_pixels.x());
  for (int row = 0; row < size_pixels.y(); ++row)
    for (int column = 0; column < size_pixels.x(); ++column)
      distance(row, column) = static_cast<float>(signed_distance_mm(solid, pose.pixel_to_world({column, row})));
  return distance;
}

}  // namespace isostack

#pragma once

#include <Eigen/Core>

#include "recon/geometry/slice.h"

namespace isostack {

/// A box or ellipsoid with axes along the world's (LPS), to add to, keep or remove from a region by hand.
/// A sphere is the ellipsoid with three equal half axes.
struct Solid {
  enum class Shape { box, ellipsoid };
  Shape shape = Shape::ellipsoid;
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_mm = Eigen::Vector3d::Ones();  ///< all > 0
};

/// Distance to the solid's surface in mm, positive inside: exact for boxes and spheres, to first order near the
/// surface of other ellipsoids (its sign is always right).
double signed_distance_mm(const Solid& solid, const Eigen::Vector3d& point_in_world_mm);

/// The same at every pixel centre of a slice; positive inside.
Image<float> signed_distance_mm(const Solid& solid, const SlicePose& pose, const Eigen::Vector2i& size_pixels);

}  // namespace isostack

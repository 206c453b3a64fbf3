#pragma once

#include <Eigen/Core>

#include "recon/geometry/slice_pose.h"
#include "recon/morphing/shape.h"

namespace isostack {

/// What a shape is like as a mass of density 1, exact for polygons and polyhedra. n = 2 (slice mm) or 3 (world mm).
struct ShapeMoments {
  double content = 0;          ///< mm² or mm³
  Eigen::VectorXd centre;      ///< n
  Eigen::MatrixXd covariance;  ///< n × n, mm², about the centre
};

/// Figures in the slice coordinates of `pose`.
ShapeMoments moments_of(const Shape& shape, const SlicePose& pose);

/// ∫ (e·(x − c))³ dx / content along each column e of `axes`: which way a shape leans, mm³.
Eigen::VectorXd third_moments(const Shape& shape, const SlicePose& pose, const Eigen::VectorXd& centre,
                              const Eigen::MatrixXd& axes);

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/constraints/contour_samples.h"
#include "recon/geometry/contour.h"

namespace isostack {

class ImplicitFunction;

/// How far contour points are from the surface, mm.
struct ContourResidual {
  double mean_mm = 0, percentile95_mm = 0, largest_mm = 0;
  std::size_t worst_slice = 0;  ///< of the farthest point, an index into the stack
};

/// Distance of each point (3 × N, world mm) to f = 0 to first order, |f|/|∇f|, mm.
Eigen::VectorXd distances_to_zero_set_mm(const ImplicitFunction& function, const Eigen::Matrix3Xd& points_mm);

/// Mean, 95 % quantile and largest of distances, of which there must be one at least.
ContourResidual residual_of(const Eigen::VectorXd& distances_mm);

/// Of the points of `samples`, which must not be empty.
ContourResidual contour_residual(const ImplicitFunction& function, const ContourStack& contours,
                                 const std::vector<ContourSample>& samples);

/// World positions of the samples, 3 × N.
Eigen::Matrix3Xd positions_mm(const std::vector<ContourSample>& samples, const ContourStack& contours);

}  // namespace isostack

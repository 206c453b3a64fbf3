#include "recon/contour_residual.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "recon/surface/implicit_function.h"

namespace isostack {

Eigen::VectorXd distances_to_zero_set_mm(const ImplicitFunction& function, const Eigen::Matrix3Xd& points_mm) {
  const Eigen::VectorXd slopes = function.gradients(points_mm).colwise().norm();
  return function.values(points_mm).array().abs() / slopes.array().max(std::numeric_limits<double>::min());
}

ContourResidual residual_of(const Eigen::VectorXd& distances_mm) {
  std::vector<double> sorted(distances_mm.begin(), distances_mm.end());
  std::sort(sorted.begin(), sorted.end());
  return {.mean_mm = distances_mm.mean(),
          .percentile95_mm = sorted[(sorted.size() - 1) * 95 / 100],
          .largest_mm = sorted.back()};
}

ContourResidual contour_residual(const ImplicitFunction& function, const ContourStack& contours,
                                 const std::vector<ContourSample>& samples) {
  const Eigen::VectorXd distances = distances_to_zero_set_mm(function, positions_mm(samples, contours));
  ContourResidual residual = residual_of(distances);
  Eigen::Index farthest = 0;
  distances.maxCoeff(&farthest);
  residual.worst_slice = samples[static_cast<std::size_t>(farthest)].slice;
  return residual;
}

Eigen::Matrix3Xd positions_mm(const std::vector<ContourSample>& samples, const ContourStack& contours) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) =
        contours.slices[samples[i].slice].pose.slice_to_world(samples[i].point_in_slice_mm);
  return points;
}

}  // namespace isostack

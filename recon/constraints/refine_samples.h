#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/constraints/contour_samples.h"

namespace isostack {

struct RefineOptions {
  double tolerance_mm = 0.1;      ///< contour points nearer to the surface need no constraint
  double spread_mm = 1;           ///< points chosen in one slice are at least this far apart
  double least_spacing_mm = 0.5;  ///< nothing is chosen nearer than this to a sample there is
  std::size_t most = 1'000;       ///< chosen at a time
};

/// All points of all contours as samples, each with its normal.
std::vector<ContourSample> all_samples(const ContourStack& contours);

/// Greedy choice of further constraints (Carr et al. 2001, §5.1): the candidates farthest from the surface, farthest
/// first, spread out and away from those `present`. `distances_mm` has one entry per candidate.
std::vector<ContourSample> farthest_samples(const std::vector<ContourSample>& candidates,
                                            const Eigen::VectorXd& distances_mm,
                                            const std::vector<ContourSample>& present, const RefineOptions& options);

}  // namespace isostack

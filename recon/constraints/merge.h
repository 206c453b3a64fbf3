#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/constraints/constraint_set.h"

namespace isostack {

/// Constraints after points that (nearly) coincide have become one. No function can meet two
/// values at one point, and a solver needs distinct points.
struct MergedConstraints {
  ConstraintSet set;                   ///< first point of each group; mean value; smallest smoothing
  std::vector<Eigen::Index> group_of;  ///< for every original constraint, its column in set
  double largest_contradiction = 0;    ///< largest difference of values within a group

  /// Means of other values for the original constraints, one per group.
  Eigen::VectorXd merged(const Eigen::VectorXd& original_values) const;
};

/// A point joins the first earlier point within `tolerance` (in the points' unit).
MergedConstraints merge_coinciding(const ConstraintSet& constraints, double tolerance);

}  // namespace isostack

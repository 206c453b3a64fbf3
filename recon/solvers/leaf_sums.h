#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/solvers/interactions.h"
#include "recon/solvers/source_field.h"
#include "recon/solvers/target_field.h"

namespace isostack {

/// Sums of a radial kernel at targets, with as many derivatives as were asked for.
struct RadialSums {
  Eigen::VectorXd values;     ///< M
  Eigen::MatrixXd gradients;  ///< n × M, or empty
  Eigen::MatrixXd hessians;   ///< 6 × M: xx, yy, zz, yz, xz, xy (3D throughout); or empty
};

enum class Derivatives { none, first, second };

/// Everything at the leaves: the far field and the near sources' terms, in the targets' own order.
/// `weights` are in the source tree's order.
RadialSums sum_at_leaves(const RadialFunction& function, const SourceField& sources, const TargetField& far,
                         const Octree& targets, const Interactions& interactions, const std::vector<double>& weights,
                         Eigen::Index dimension, Derivatives derivatives);

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <optional>

#include "recon/solvers/interactions.h"
#include "recon/solvers/radial_sums.h"
#include "recon/solvers/source_field.h"
#include "recon/solvers/target_field.h"

namespace isostack {

struct FastSumOptions {
  FarFieldOptions far_field;
  int leaf_size = 90;  ///< points per octree leaf on average
};

/// Σ_j weights_j φ(|x_i − c_j|) for many weights between fixed points of at most three dimensions:
/// near points term by term, far ones by an interpolation-based fast multipole method. Work grows
/// like N. Results do not depend on the number of threads. Not to be used from two threads at once.
class FastSum {
 public:
  /// The targets are the sources themselves.
  FastSum(const RadialFunction& function, const Eigen::MatrixXd& sources, const FastSumOptions& options);
  FastSum(const RadialFunction& function, const Eigen::MatrixXd& sources, const Eigen::MatrixXd& targets,
          const FastSumOptions& options);
  FastSum(const FastSum&) = delete;
  FastSum& operator=(const FastSum&) = delete;

  Eigen::VectorXd values(const Eigen::VectorXd& weights) { return sums(weights, Derivatives::none).values; }
  RadialSums sums(const Eigen::VectorXd& weights, Derivatives derivatives);

  std::size_t bytes() const;
  const Interactions& interactions() const { return interactions_; }

 private:
  const Octree& targets() const { return own_targets_ ? *own_targets_ : sources_; }

  RadialFunction function_;
  Eigen::Index dimension_;
  Octree sources_;
  std::optional<Octree> own_targets_;
  Interactions interactions_;
  SourceField source_field_;
  TargetField target_field_;
};

/// Axes across which all points of both trees lie in one plane.
std::array<bool, 3> flat_axes(const Octree& a, const Octree& b);

}  // namespace isostack

#pragma once

#include <Eigen/Core>

#include "recon/kernels/kernel.h"
#include "recon/solvers/radial_weights.h"

namespace isostack {

/// f(x) = Σ_j w_j φ(|x − c_j|) + p(x) (Turk & O'Brien 1999, eq. 2); f > 0 inside, in the units of
/// the constraints' values. Points are n × M, one a column.
class ImplicitFunction {
 public:
  /// Centres are n × N in the order of solution.weights.
  ImplicitFunction(const Kernel& kernel, Eigen::MatrixXd centres, RadialWeights solution);

  Eigen::Index dimension() const { return centres_.rows(); }
  Eigen::VectorXd values(const Eigen::MatrixXd& points) const;
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& points) const;

 private:
  Kernel kernel_;
  Eigen::MatrixXd centres_;
  RadialWeights solution_;
};

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <memory>

#include "recon/kernels/kernel.h"
#include "recon/solvers/fast_field.h"
#include "recon/solvers/radial_weights.h"

namespace isostack {

/// f(x) = Σ_j w_j φ(|x − c_j|) + p(x) (Turk & O'Brien 1999, eq. 2); f > 0 inside, in the units of
/// the constraints' values. Points are n × M, one a column. Copies share their centres.
class ImplicitFunction {
 public:
  /// Centres are n × N in the order of solution.weights. Many centres in up to three dimensions are
  /// summed fast, to `tolerance`.
  ImplicitFunction(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& solution,
                   double tolerance = 1e-5);

  Eigen::Index dimension() const { return centres_->rows(); }
  Eigen::VectorXd values(const Eigen::MatrixXd& points) const;
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& points) const;

 private:
  Kernel kernel_;
  std::shared_ptr<const Eigen::MatrixXd> centres_;
  std::shared_ptr<const RadialWeights> solution_;
  std::shared_ptr<const FastField> fast_;  ///< null: summed term by term
};

}  // namespace isostack

#include "recon/surface/implicit_function.h"

#include "recon/solvers/direct_sum.h"

namespace isostack {

namespace {

// Below, setting up the fast sums takes as long as the sums they save.
constexpr Eigen::Index least_centres_for_fast_sums = 3000;

}  // namespace

ImplicitFunction::ImplicitFunction(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& solution,
                                   double tolerance)
    : kernel_(kernel),
      centres_(std::make_shared<const Eigen::MatrixXd>(centres)),
      solution_(std::make_shared<const RadialWeights>(solution)) {
  if (centres.rows() <= 3 && centres.cols() >= least_centres_for_fast_sums)
    fast_ = std::make_shared<const FastField>(kernel, centres, solution.weights,
                                              FastField::Options{.tolerance = tolerance});
}

Eigen::VectorXd ImplicitFunction::values(const Eigen::MatrixXd& points) const {
  const Eigen::VectorXd tail = solution_->tail.values(points) * solution_->tail_coefficients;
  return tail + (fast_ ? fast_->values(points) : direct_sum(kernel_, *centres_, solution_->weights, points));
}

Eigen::MatrixXd ImplicitFunction::gradients(const Eigen::MatrixXd& points) const {
  const Eigen::MatrixXd tail = solution_->tail.gradients(points, solution_->tail_coefficients);
  return tail +
         (fast_ ? fast_->gradients(points) : direct_sum_gradient(kernel_, *centres_, solution_->weights, points));
}

}  // namespace isostack

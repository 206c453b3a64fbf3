#include "recon/surface/implicit_function.h"

#include <utility>

#include "recon/solvers/direct_sum.h"

namespace isostack {

ImplicitFunction::ImplicitFunction(const Kernel& kernel, Eigen::MatrixXd centres, RadialWeights solution)
    : kernel_(kernel), centres_(std::move(centres)), solution_(std::move(solution)) {}

Eigen::VectorXd ImplicitFunction::values(const Eigen::MatrixXd& points) const {
  return direct_sum(kernel_, centres_, solution_.weights, points) +
         solution_.tail.values(points) * solution_.tail_coefficients;
}

Eigen::MatrixXd ImplicitFunction::gradients(const Eigen::MatrixXd& points) const {
  return direct_sum_gradient(kernel_, centres_, solution_.weights, points) +
         solution_.tail.gradients(points, solution_.tail_coefficients);
}

}  // namespace isostack

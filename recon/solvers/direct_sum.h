#pragma once

#include <Eigen/Core>

#include "recon/kernels/kernel.h"
#include "recon/solvers/radial_function.h"
#include "recon/solvers/radial_sums.h"

namespace isostack {

/// Σ_j weights_j φ(|x − c_j|) by summing every term: the reference for the fast sums, and the
/// right tool for small sizes. Centres are n × N and targets n × M, n = 1…6.
/// SIMD is chosen at run time; results do not depend on the number of threads.
Eigen::VectorXd direct_sum(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                           const Eigen::MatrixXd& targets);

/// Gradient of the same sum at the targets: n × M.
Eigen::MatrixXd direct_sum_gradient(const Kernel& kernel, const Eigen::MatrixXd& centres,
                                    const Eigen::VectorXd& weights, const Eigen::MatrixXd& targets);

/// Values and derivatives in one pass. Second derivatives are given up to n = 3.
RadialSums direct_sums(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                       const Eigen::MatrixXd& targets, Derivatives derivatives);

/// The same with centres a fixed distance off in a further dimension.
RadialSums direct_sums(const RadialFunction& function, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                       const Eigen::MatrixXd& targets, Derivatives derivatives);

}  // namespace isostack

#pragma once

#include <Eigen/Core>
#include <random>

#include "recon/solvers/direct_sum.h"
#include "recon/solvers/fast_solver.h"
#include "tests/benchmarks/star_stack.h"

namespace isostack {

/// n × count, uniform in ±100.
inline Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-100, 100);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

/// f at points, term by term.
inline Eigen::VectorXd evaluate(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& f,
                                const Eigen::MatrixXd& at) {
  return direct_sum(kernel, centres, f.weights, at) + f.tail.values(at) * f.tail_coefficients;
}

inline FastSolverOptions to(double tolerance) {
  FastSolverOptions options;
  options.tolerance = tolerance;
  return options;
}

}  // namespace isostack

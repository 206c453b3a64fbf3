// What the solver benchmarks have in common.
#pragma once

#include <Eigen/Core>

#include "recon/kernels/kernel.h"
#include "recon/solvers/fast_solver.h"

namespace isostack::benchmarks {

/// Largest |f(x_i) − value_i| at 10,000 of the constraints, drawn with a fixed seed, every term summed: not the
/// solver's own check, which draws others.
double largest_residual(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                        const RadialWeights& solution);

struct MeasuredSolve {
  Solution solution;
  double seconds = 0;
};

/// Builds the fast solver with its default settings and solves once.
MeasuredSolve measured_solve(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                             double tolerance);

/// A line "key value" each, as run.sh reads them: constraints, seconds, iterations, peak_gb, residual, the solver's own
/// figure for that, stages. The peak is
/// that of the process before the residual is computed. Returns the program's exit code.
int print_solve(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values, double tolerance);

}  // namespace isostack::benchmarks

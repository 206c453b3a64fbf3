#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/kernels/kernel.h"
#include "recon/solvers/coarse_to_fine.h"
#include "recon/solvers/kernel_operator.h"
#include "recon/solvers/radial_weights.h"
#include "recon/solvers/sparse_factor.h"
#include "recon/solvers/tail_space.h"

namespace isostack {

struct FastSolverOptions {
  double tolerance = 1e-5;  ///< largest residual asked for, in the values' units
  std::size_t memory_limit_bytes = std::size_t{8} << 30;
  int most_iterations = 300;
  int checked_constraints = 10000;  ///< summed term by term to check the residual
  CoarseToFineOptions preconditioner;
  /// The product inside the iteration and the one that corrects it; unset: chosen by the kernel.
  std::optional<FastSumOptions> inner, outer;
  double sweep_reduction = 1e-3;  ///< of the residual between two corrections
};

/// What a solve did, for the report.
struct SolveStage {
  std::string name;
  double seconds = 0;
  std::size_t bytes = 0;  ///< held by the stage's result
};

struct Solution {
  RadialWeights function;       ///< weights and tail for the points as they were given
  double largest_residual = 0;  ///< by direct sums at the checked constraints
  bool converged = false;       ///< the residual is within the tolerance
  int iterations = 0, sweeps = 0;
  std::string remark;  ///< where and why, when it did not converge
  std::vector<SolveStage> stages;
};

/// The linear system of Turk & O'Brien 1999, eq. 3, for up to millions of constraints: conjugate
/// gradients on the weights that annihilate the tail's polynomials, with fast products, a sparse
/// inverse Cholesky factor as preconditioner, and iterative refinement with a more accurate product.
class FastSolver {
 public:
  /// Points are n × N, distinct; smoothing is empty or one ρ ≥ 0 per point (0 interpolates).
  /// Throws SolveError when the predicted memory exceeds the limit.
  FastSolver(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
             const FastSolverOptions& options, const Progress& progress = {});

  /// One value per point. `start` are weights of an earlier solution, or empty.
  /// The best solution reached is returned also when it misses the tolerance.
  Solution solve(const Eigen::VectorXd& values, const Eigen::VectorXd& start = {}, const Progress& progress = {});

  /// Of the solves that follow.
  void set_tolerance(double tolerance) { options_.tolerance = tolerance; }

  /// What the solve will hold at most, as predicted before it started.
  std::size_t predicted_bytes() const { return predicted_bytes_; }
  /// The same for points (n × N) that are not solved for.
  static std::size_t required_bytes(const Eigen::MatrixXd& points, const Kernel& kernel,
                                    const CoarseToFineOptions& preconditioner);

 private:
  struct Iteration;
  Eigen::VectorXd system_times(KernelOperator& product, const Eigen::VectorXd& weights) const;
  bool iterate(Iteration& state, double target, int most, const Progress& progress);
  bool outer_is_direct() const { return order_.size() <= 20'000; }
  Eigen::VectorXd accurate_times(const Eigen::VectorXd& weights);
  bool raise_outer_order();
  bool may_grow() const;
  void correct(Iteration& state, const Eigen::VectorXd& values);
  void refine(Iteration& state, const Eigen::VectorXd& values, Solution& solution, const Progress& progress);
  double checked_residual(const Iteration& state, const Eigen::VectorXd& values, Solution& solution) const;

  Kernel kernel_;
  FastSolverOptions options_;
  std::size_t predicted_bytes_ = 0;
  std::vector<std::uint32_t> order_;  ///< column of the k-th point along the curve
  Eigen::MatrixXd places_;            ///< the points as given, in that order
  Eigen::MatrixXd points_;            ///< the same in the coordinates they span
  Eigen::VectorXd smoothing_;
  PolynomialBasis basis_;
  std::vector<SolveStage> stages_;
  std::optional<TailSpace> tail_;
  std::optional<SparseFactor> preconditioner_;
  FastSumOptions inner_options_, outer_options_;
  std::optional<KernelOperator> inner_, outer_;
};

}  // namespace isostack

#include "recon/solvers/interpolation_solver.h"

#include "recon/solvers/direct_sum.h"

namespace isostack {

namespace {

// Measured: from here on the fast solver takes less time.
constexpr std::size_t least_constraints_for_fast = 8000;
// Slices far apart need many neighbours; below this the larger factor pays for itself.
constexpr Eigen::Index many_constraints = 150'000;

double largest_residual(const Kernel& kernel, const ConstraintSet& set, const Eigen::VectorXd& values,
                        const RadialWeights& solution) {
  Eigen::VectorXd residual = values - direct_sum(kernel, set.points, solution.weights, set.points) -
                             solution.tail.values(set.points) * solution.tail_coefficients;
  if (set.smoothing.size() > 0) residual -= kernel.sign() * set.smoothing.cwiseProduct(solution.weights);
  return residual.cwiseAbs().maxCoeff();
}

}  // namespace

bool InterpolationSolver::uses_fast(SolverChoice choice, std::size_t constraint_count) {
  return choice == SolverChoice::fast ||
         (choice == SolverChoice::automatic && constraint_count >= least_constraints_for_fast);
}

InterpolationSolver::InterpolationSolver(const ConstraintSet& constraints, const InterpolationOptions& options,
                                         const Progress& progress)
    : options_(options), merged_(merge_coinciding(constraints, options.merge_distance)) {
  const ConstraintSet& set = merged_.set;
  if (uses_fast(options.solver, static_cast<std::size_t>(set.values.size()))) {
    FastSolverOptions fast;
    fast.tolerance = options.tolerance;
    fast.memory_limit_bytes = options.memory_limit_bytes;
    fast.preconditioner.neighbours = set.values.size() < many_constraints ? 80 : 40;
    fast_ = std::make_unique<FastSolver>(options.kernel, set.points, set.smoothing, fast, progress);
  } else {
    dense_ =
        std::make_unique<DenseSolver>(options.kernel, set.points, set.smoothing,
                                      DenseSolver::Options{.memory_limit_bytes = options.memory_limit_bytes}, progress);
  }
}

std::size_t InterpolationSolver::predicted_bytes() const {
  const auto count = static_cast<std::size_t>(merged_.set.values.size());
  return fast_ ? FastSolver::required_bytes(count, options_.kernel) : DenseSolver::required_bytes(count);
}

RadialWeights InterpolationSolver::solve(const Eigen::VectorXd& values, const Eigen::VectorXd& start,
                                         SolveReport& report, const Progress& progress) {
  const Eigen::VectorXd merged_values = merged_.merged(values);
  if (dense_) {
    RadialWeights solution = dense_->solve(merged_values);
    report = {.solver = "dense",
              .largest_residual = largest_residual(options_.kernel, merged_.set, merged_values, solution),
              .converged = true,
              .iterations = 0,
              .remark = ""};
    return solution;
  }
  if (last_weights_.size() == 0 && start.size() > 0) {
    last_weights_ = Eigen::VectorXd::Zero(merged_values.size());
    last_weights_.head(start.size()) = start;
  }
  const Solution solution = fast_->solve(merged_values, last_weights_, progress);
  last_weights_ = solution.function.weights;
  report = {.solver = "fast",
            .largest_residual = solution.largest_residual,
            .converged = solution.converged,
            .iterations = solution.iterations,
            .remark = solution.remark};
  return solution.function;
}

}  // namespace isostack

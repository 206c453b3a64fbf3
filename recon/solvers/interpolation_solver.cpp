#include "recon/solvers/interpolation_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solvers/direct_sum.h"

namespace isostack {

namespace {

// Measured: from here on the fast solver takes less time.
constexpr std::size_t least_constraints_for_fast = 8000;
// Slices far apart need many neighbours; below this the larger factor pays for itself.
constexpr Eigen::Index many_constraints = 150'000;

FastSolverOptions fast_options(const InterpolationOptions& options, Eigen::Index constraint_count) {
  FastSolverOptions fast;
  fast.tolerance = options.tolerance;
  fast.memory_limit_bytes = options.memory_limit_bytes;
  fast.preconditioner.neighbours = constraint_count < many_constraints ? 80 : 40;
  return fast;
}

/// How far apart 90 % of the numbers lie: a stray point does not stretch it.
double inner_range(const Eigen::VectorXd& numbers) {
  std::vector<double> sorted(numbers.begin(), numbers.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[(sorted.size() - 1) * 19 / 20] - sorted[sorted.size() / 20];
}

/// Nearer points than this are the same to a kernel matrix in double precision: r³ vanishes beside the extent's.
double least_merge_distance(const Eigen::MatrixXd& points) {
  double squared = 0;
  for (const auto& coordinates : points.rowwise()) squared += std::pow(inner_range(coordinates.transpose()), 2);
  return 1e-7 * std::sqrt(squared);
}

/// Solvers would carry a number that is none into every weight.
void require_numbers(const ConstraintSet& constraints) {
  if (constraints.values.size() == 0) throw InputError("constraints", "there are none", "give slices with contours");
  for (Eigen::Index i = 0; i < constraints.values.size(); ++i)
    if (!constraints.points.col(i).allFinite() || !std::isfinite(constraints.values[i]) ||
        (constraints.smoothing.size() > 0 && !(constraints.smoothing[i] >= 0)))
      throw InputError(
          "constraints",
          fmt::format("number {} of {} is not finite, or its smoothing is negative", i + 1, constraints.values.size()),
          "check the contours it comes from");
}

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
    : options_(options) {
  require_numbers(constraints);
  const Stopwatch merge_watch;
  merged_ = merge_coinciding(constraints, std::max(options.merge_distance, least_merge_distance(constraints.points)));
  const ConstraintSet& set = merged_.set;
  const auto bytes = static_cast<std::size_t>(set.points.size() + set.values.size()) * sizeof(double);
  unreported_.push_back({"merge", merge_watch.seconds(), bytes});
  if (uses_fast(options.solver, static_cast<std::size_t>(set.values.size()))) {
    fast_ = std::make_unique<FastSolver>(options.kernel, set.points, set.smoothing,
                                         fast_options(options, set.values.size()), progress);
  } else {
    const Stopwatch factor_watch;
    dense_ =
        std::make_unique<DenseSolver>(options.kernel, set.points, set.smoothing,
                                      DenseSolver::Options{.memory_limit_bytes = options.memory_limit_bytes}, progress);
    unreported_.push_back({"factorise", factor_watch.seconds(), predicted_bytes()});
  }
}

std::size_t InterpolationSolver::predicted_bytes() const {
  const auto count = static_cast<std::size_t>(merged_.set.values.size());
  return fast_ ? fast_->predicted_bytes() : DenseSolver::required_bytes(count);
}

std::size_t InterpolationSolver::required_bytes(const Eigen::MatrixXd& points, const InterpolationOptions& options) {
  const auto count = static_cast<std::size_t>(points.cols());
  if (!uses_fast(options.solver, count)) return DenseSolver::required_bytes(count);
  return FastSolver::required_bytes(points, options.kernel, fast_options(options, points.cols()).preconditioner);
}

RadialWeights InterpolationSolver::solve(const Eigen::VectorXd& values, const Eigen::VectorXd& start,
                                         SolveReport& report, const Progress& progress) {
  if (!values.allFinite()) throw InputError("constraints", "a value is not finite", "check the contours");
  const Eigen::VectorXd merged_values = merged_.merged(values);
  report = {};
  report.tolerance = options_.tolerance;
  report.predicted_bytes = predicted_bytes();
  RadialWeights solution =
      dense_ ? solve_dense(merged_values, report) : solve_fast(merged_values, start, report, progress);
  report.stages.insert(report.stages.begin(), unreported_.begin(), unreported_.end());
  unreported_.clear();
  built_is_reported_ = true;
  return solution;
}

void InterpolationSolver::set_tolerance(double tolerance) {
  options_.tolerance = tolerance;
  if (fast_) fast_->set_tolerance(tolerance);
}

RadialWeights InterpolationSolver::solve_dense(const Eigen::VectorXd& values, SolveReport& report) const {
  const Stopwatch watch;
  RadialWeights solution = dense_->solve(values);
  report.solver = "dense";
  report.largest_residual = largest_residual(options_.kernel, merged_.set, values, solution);
  report.converged = report.largest_residual <= options_.tolerance;
  if (!report.converged)
    report.remark = "the system is close to singular: constraints lie too close together for their extent";
  report.stages.push_back({"solve", watch.seconds(), static_cast<std::size_t>(3 * values.size()) * sizeof(double)});
  return solution;
}

RadialWeights InterpolationSolver::solve_fast(const Eigen::VectorXd& values, const Eigen::VectorXd& start,
                                              SolveReport& report, const Progress& progress) {
  if (last_weights_.size() == 0 && start.size() > 0) {
    last_weights_ = Eigen::VectorXd::Zero(values.size());
    last_weights_.head(start.size()) = start;
  }
  Solution solution = fast_->solve(values, last_weights_, progress);
  last_weights_ = solution.function.weights;
  report.solver = "fast";
  report.largest_residual = solution.largest_residual;
  report.converged = solution.converged;
  report.iterations = solution.iterations;
  report.sweeps = solution.sweeps;
  report.remark = solution.remark;
  report.stages = std::move(solution.stages);
  // The fast solver repeats the stages of its building in every solution.
  if (built_is_reported_) std::erase_if(report.stages, [](const SolveStage& stage) { return stage.name != "solve"; });
  return std::move(solution.function);
}

}  // namespace isostack

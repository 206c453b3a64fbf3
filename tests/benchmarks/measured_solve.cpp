#include "tests/benchmarks/measured_solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <vector>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solvers/direct_sum.h"

namespace isostack::benchmarks {

namespace {

/// The sum in blocks of centres: at a million constraints r³ has terms of 10¹¹ in all that cancel to about 1, and one
/// running sum in double precision would be wrong by 10⁻³.
Eigen::VectorXd sum_in_blocks(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                              const Eigen::MatrixXd& at) {
  constexpr Eigen::Index block = 1024;
  Eigen::Matrix<long double, Eigen::Dynamic, 1> total = decltype(total)::Zero(at.cols());
  for (Eigen::Index first = 0; first < centres.cols(); first += block) {
    const Eigen::Index count = std::min(block, centres.cols() - first);
    total +=
        direct_sum(kernel, centres.middleCols(first, count), weights.segment(first, count), at).cast<long double>();
  }
  return total.cast<double>();
}

}  // namespace

double largest_residual(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                        const RadialWeights& solution) {
  std::mt19937_64 random(1999);
  std::vector<Eigen::Index> sample(static_cast<std::size_t>(std::min<Eigen::Index>(10'000, values.size())));
  for (Eigen::Index& one : sample)
    one = static_cast<Eigen::Index>(random() % static_cast<std::uint64_t>(values.size()));
  const Eigen::MatrixXd at = points(Eigen::all, sample);
  const Eigen::VectorXd function =
      sum_in_blocks(kernel, points, solution.weights, at) + solution.tail.values(at) * solution.tail_coefficients;
  return (function - values(sample)).cwiseAbs().maxCoeff();
}

MeasuredSolve measured_solve(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                             double tolerance) {
  FastSolverOptions options;
  options.tolerance = tolerance;
  options.memory_limit_bytes = std::size_t{16} << 30;
  const Stopwatch watch;
  FastSolver solver(kernel, points, {}, options);
  MeasuredSolve result;
  result.solution = solver.solve(values);
  result.seconds = watch.seconds();
  return result;
}

int print_solve(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& values, double tolerance) {
  const MeasuredSolve solve = measured_solve(kernel, points, values, tolerance);
  fmt::print("constraints {}\nseconds {:.2f}\niterations {}\npeak_gb {:.2f}\n", values.size(), solve.seconds,
             solve.solution.iterations, static_cast<double>(peak_memory_bytes()) / 1e9);
  fmt::print("residual {:.1e}\n", largest_residual(kernel, points, values, solve.solution.function));
  fmt::print("own_residual {:.1e}\n", solve.solution.largest_residual);
  for (const SolveStage& stage : solve.solution.stages)
    fmt::print("stage_{} {:.2f} s, {:.2f} GB\n", stage.name, stage.seconds, static_cast<double>(stage.bytes) / 1e9);
  return solve.solution.converged ? 0 : 1;
}

}  // namespace isostack::benchmarks

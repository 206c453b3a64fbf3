// evaluate_star_stack SLICES POINTS: f and ∇f of the solved contour stack (kernel r, residual 1e-5) at random points in
// its box, in seconds and in products of the solver: the kernel matrix times a vector.
#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/fast_field.h"
#include "recon/solvers/kernel_operator.h"
#include "tests/benchmarks/measured_solve.h"
#include "tests/benchmarks/star_stack.h"

namespace isostack::benchmarks {
namespace {

constexpr double tolerance = 1e-5;

Eigen::MatrixXd points_in_box(const Eigen::MatrixXd& points, Eigen::Index count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Eigen::VectorXd least = points.rowwise().minCoeff(), size = points.rowwise().maxCoeff() - least;
  const Eigen::MatrixXd unit = Eigen::MatrixXd::NullaryExpr(3, count, [&] { return uniform(random); });
  return (size.asDiagonal() * unit).colwise() + least;
}

/// Of a product of the solver: with order 6 and leaves of 90 the one in every iteration, with order 9 and leaves of
/// 150 the one that corrects it, whose error is that asked of the evaluation.
double product_seconds(const Kernel& kernel, const StarStack& stack, const Eigen::VectorXd& weights, int order,
                       int leaf_size) {
  FastSumOptions options;
  options.far_field.order = order;
  options.leaf_size = leaf_size;
  KernelOperator product(kernel, stack.points, options);
  product.times(weights);
  const Stopwatch watch;
  for (int k = 0; k < 3; ++k) product.times(weights);
  return watch.seconds() / 3;
}

int run(int slices, Eigen::Index count) {
  const Kernel kernel = biharmonic();
  const StarStack stack = star_stack(slices);
  const RadialWeights solution = measured_solve(kernel, stack.points, stack.values, tolerance).solution.function;
  const double inner = product_seconds(kernel, stack, solution.weights, 6, 90);
  const double outer = product_seconds(kernel, stack, solution.weights, 9, 150);
  const Eigen::MatrixXd at = points_in_box(stack.points, count);

  const Stopwatch prepare_watch;
  const FastField field(kernel, stack.points, solution.weights, {.tolerance = tolerance});
  const double prepare = prepare_watch.seconds();
  const Stopwatch first_watch;
  const RadialSums sums = field.sums(at, Derivatives::first);
  const double first = first_watch.seconds();
  const Stopwatch again_watch;
  field.sums(at, Derivatives::first);
  const double again = again_watch.seconds();

  fmt::print("constraints {}\nseconds {:.2f}\nproduct_seconds {:.2f}\npeak_gb {:.2f}\n", stack.values.size(), first,
             inner, static_cast<double>(peak_memory_bytes()) / 1e9);
  const Eigen::MatrixXd some = at.leftCols(1000);
  const Eigen::VectorXd exact = direct_sum(kernel, stack.points, solution.weights, some);
  const Eigen::MatrixXd exact_gradient = direct_sum_gradient(kernel, stack.points, solution.weights, some);
  fmt::print("residual {:.1e}\n", (sums.values.head(1000) - exact).cwiseAbs().maxCoeff());
  fmt::print(
      "remark f and ∇f {:.2f} s = {:.2f} products of an iteration ({:.2f} s) = {:.2f} of the correcting product "
      "({:.2f} "
      "s); again in the same place {:.2f} s; before the first {:.2f} s; error of ∇f {:.1e}\n",
      first, first / inner, inner, first / outer, outer, again, prepare,
      (sums.gradients.leftCols(1000) - exact_gradient).cwiseAbs().maxCoeff());
  return 0;
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: evaluate_star_stack SLICES POINTS\n");
    return 2;
  }
  try {
    return isostack::benchmarks::run(std::atoi(argv[1]), std::atoi(argv[2]));
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}

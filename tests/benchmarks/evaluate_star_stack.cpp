// evaluate_star_stack SLICES POINTS: f and ∇f of the solved contour stack (kernel r, residual 1e-5) at random points in
// its box, in seconds and in products of the solver: the kernel matrix times a vector, as in one iteration.
#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/kernel_operator.h"
#include "recon/surface/implicit_function.h"
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

double product_seconds(const Kernel& kernel, const StarStack& stack, const Eigen::VectorXd& weights) {
  FastSumOptions inner;  // as the solver's for r
  inner.far_field.order = 6;
  inner.leaf_size = 90;
  KernelOperator product(kernel, stack.points, inner);
  product.times(weights);
  const Stopwatch watch;
  for (int k = 0; k < 3; ++k) product.times(weights);
  return watch.seconds() / 3;
}

int run(int slices, Eigen::Index count) {
  const Kernel kernel = biharmonic();
  const StarStack stack = star_stack(slices);
  const RadialWeights solution = measured_solve(kernel, stack.points, stack.values, tolerance).solution.function;
  const double unit = product_seconds(kernel, stack, solution.weights);
  const Eigen::MatrixXd at = points_in_box(stack.points, count);

  const Stopwatch prepare_watch;
  const ImplicitFunction f(kernel, stack.points, solution, tolerance);
  const double prepare = prepare_watch.seconds();
  const Stopwatch value_watch;
  const Eigen::VectorXd values = f.values(at);
  const double value_seconds = value_watch.seconds();
  const Stopwatch gradient_watch;
  const Eigen::MatrixXd gradients = f.gradients(at);
  const double gradient_seconds = gradient_watch.seconds();

  fmt::print("constraints {}\nseconds {:.2f}\nproduct_seconds {:.2f}\npeak_gb {:.2f}\n", stack.values.size(),
             value_seconds + gradient_seconds, unit, static_cast<double>(peak_memory_bytes()) / 1e9);
  const Eigen::MatrixXd some = at.leftCols(1000);
  const Eigen::VectorXd exact = direct_sum(kernel, stack.points, solution.weights, some) +
                                solution.tail.values(some) * solution.tail_coefficients;
  const Eigen::MatrixXd exact_gradient = direct_sum_gradient(kernel, stack.points, solution.weights, some) +
                                         solution.tail.gradients(some, solution.tail_coefficients);
  fmt::print("residual {:.1e}\n", (values.head(1000) - exact).cwiseAbs().maxCoeff());
  fmt::print(
      "remark f {:.2f} s = {:.2f} products, ∇f {:.2f} s = {:.2f} products of {:.2f} s; before the first {:.2f} s; "
      "error of ∇f {:.1e}\n",
      value_seconds, value_seconds / unit, gradient_seconds, gradient_seconds / unit, unit, prepare,
      (gradients.leftCols(1000) - exact_gradient).cwiseAbs().maxCoeff());
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

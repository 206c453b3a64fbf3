#include "recon/solvers/fast_solver.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <random>
#include <string>

#include "recon/solvers/direct_sum.h"
#include "tests/support/solver_cases.h"

namespace isostack {
namespace {

using benchmarks::star_stack;
using benchmarks::StarStack;

class FastSolverKernels : public testing::TestWithParam<std::string> {
 protected:
  Kernel kernel = kernel_named(GetParam());
};

TEST_P(FastSolverKernels, InterpolatesInTwoDimensions) {
  const Eigen::MatrixXd points = random_points(2, 4000, 2);
  const Eigen::VectorXd values = (points.row(0).array() / 20).sin() + points.row(1).array() / 50;
  const Solution solution = FastSolver(kernel, points, {}, to(1e-5)).solve(values);
  EXPECT_TRUE(solution.converged) << solution.largest_residual;
  EXPECT_LT((evaluate(kernel, points, solution.function, points) - values).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_P(FastSolverKernels, PolynomialsOfTheTailAreReproduced) {
  const Eigen::MatrixXd points = random_points(3, 3000, 3), at = random_points(3, 100, 4);
  const auto plane = [](const Eigen::MatrixXd& x) -> Eigen::VectorXd {
    return (2 + 0.3 * x.row(0).array() - 0.1 * x.row(2).array()).transpose();
  };
  const Solution solution = FastSolver(kernel, points, {}, to(1e-6)).solve(plane(points));
  EXPECT_LT((evaluate(kernel, points, solution.function, at) - plane(at)).cwiseAbs().maxCoeff(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, FastSolverKernels, testing::Values("biharmonic", "thin_plate", "triharmonic"),
                         [](const auto& one) { return one.param; });

TEST(FastSolver, FourDimensionsInLayers) {
  Eigen::MatrixXd points = random_points(4, 5000, 6);
  for (int i = 0; i < 5000; ++i) points(3, i) = i % 2 ? 100 : 0;
  Eigen::VectorXd values(5000);
  for (int i = 0; i < 5000; ++i) values[i] = 80 - points.col(i).head(3).norm() * (i % 2 ? 1.3 : 1);
  const Solution solution = FastSolver(triharmonic(), points, {}, to(1e-5)).solve(values);
  EXPECT_TRUE(solution.converged) << solution.largest_residual;
}

TEST(FastSolver, StartsFromAnEarlierSolution) {
  const StarStack c = star_stack(6, 2);
  FastSolver solver(biharmonic(), c.points, {}, to(1e-5));
  const Solution cold = solver.solve(c.values);
  const Solution warm = solver.solve(c.values, cold.function.weights);
  EXPECT_TRUE(warm.converged);
  EXPECT_LT(warm.iterations, cold.iterations / 2);
}

TEST(FastSolver, OneAndTwoThreadsGiveTheSameBits) {
  const StarStack c = star_stack(4, 2);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return FastSolver(biharmonic(), c.points, {}, to(1e-5)).solve(c.values).function.weights;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

}  // namespace
}  // namespace isostack

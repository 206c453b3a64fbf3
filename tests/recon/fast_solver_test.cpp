#include "recon/solvers/fast_solver.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/solvers/dense_solver.h"
#include "recon/solvers/direct_sum.h"

namespace isostack {
namespace {

struct Constraints {
  Eigen::MatrixXd points;
  Eigen::VectorXd values;
};

/// Star contours 5 mm apart, points about `spacing` mm apart, each with a partner of value 1, 1 mm inside.
Constraints star_contours(int slices, double spacing) {
  std::vector<double> coordinates, values;
  for (int slice = 0; slice < slices; ++slice) {
    const double z = 5.0 * slice;
    const int count = static_cast<int>(760 / spacing);
    for (int i = 0; i < count; ++i) {
      const double a = 2 * std::numbers::pi * i / count, r = 100 + 20 * std::cos(5 * a + 0.02 * z);
      const double slope = -100 * std::sin(5 * a + 0.02 * z);
      const Eigen::Vector2d point(r * std::cos(a), r * std::sin(a));
      const Eigen::Vector2d tangent(slope * std::cos(a) - r * std::sin(a), slope * std::sin(a) + r * std::cos(a));
      const Eigen::Vector2d inner = point + Eigen::Vector2d(-tangent.y(), tangent.x()).normalized();
      for (const double x : {point.x(), point.y(), z, inner.x(), inner.y(), z}) coordinates.push_back(x);
      values.push_back(0);
      values.push_back(1);
    }
  }
  return {Eigen::Map<Eigen::MatrixXd>(coordinates.data(), 3, static_cast<Eigen::Index>(values.size())),
          Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))};
}

Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-100, 100);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

Eigen::VectorXd evaluate(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& f,
                         const Eigen::MatrixXd& at) {
  return direct_sum(kernel, centres, f.weights, at) + f.tail.values(at) * f.tail_coefficients;
}

FastSolverOptions to(double tolerance) {
  FastSolverOptions options;
  options.tolerance = tolerance;
  return options;
}

class FastSolverKernels : public testing::TestWithParam<std::string> {
 protected:
  Kernel kernel = kernel_named(GetParam());
};

// The bar: f agrees with the dense solver's within ten times the requested residual.
TEST_P(FastSolverKernels, AgreesWithTheDenseSolver) {
  const Constraints c = star_contours(7, 1.7);  // more than the direct sums' share
  const Eigen::MatrixXd at = random_points(3, 2000, 1);
  for (const double rho : {0.0, 0.5}) {
    const Eigen::VectorXd smoothing =
        rho > 0 ? Eigen::VectorXd::Constant(c.values.size(), rho).eval() : Eigen::VectorXd();
    const Solution fast = FastSolver(kernel, c.points, smoothing, to(1e-5)).solve(c.values);
    EXPECT_TRUE(fast.converged) << fast.largest_residual << " " << fast.remark;
    const RadialWeights dense = DenseSolver(kernel, c.points, smoothing, {}).solve(c.values);
    const Eigen::VectorXd difference =
        evaluate(kernel, c.points, fast.function, at) - evaluate(kernel, c.points, dense, at);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-4) << rho;
  }
}

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

TEST(FastSolver, FewestPoints) {
  for (const int count : {4, 5, 9, 30, 70}) {
    const Eigen::MatrixXd points = random_points(3, count, static_cast<unsigned>(count));
    const Eigen::VectorXd values = points.row(0).array().square() / 1000;
    const Solution solution = FastSolver(triharmonic(), points, {}, to(1e-8)).solve(values);
    EXPECT_TRUE(solution.converged) << count << " " << solution.largest_residual;
  }
}

TEST(FastSolver, PointsInAnObliquePlane) {
  const Eigen::MatrixXd flat = random_points(2, 3000, 5);
  Eigen::MatrixXd points(3, 3000);
  points << flat, (0.3 * flat.row(0) - 0.8 * flat.row(1)).array() + 12;
  const Eigen::VectorXd values = (flat.row(0).array() / 30).cos();
  const Solution solution = FastSolver(biharmonic(), points, {}, to(1e-5)).solve(values);
  EXPECT_TRUE(solution.converged) << solution.largest_residual;
}

TEST(FastSolver, FarFromTheOriginAndInOtherUnitsTheFunctionIsTheSame) {
  const Constraints c = star_contours(4, 2);
  const Eigen::MatrixXd at = c.points.leftCols(500).array() + 3;
  const Solution solution = FastSolver(triharmonic(), c.points, {}, to(1e-6)).solve(c.values);
  const Eigen::VectorXd reference = evaluate(triharmonic(), c.points, solution.function, at);
  for (const double unit : {1e-3, 1e3}) {
    const auto move = [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return (x * unit).array() + 1e4 * unit; };
    const Solution moved = FastSolver(triharmonic(), move(c.points), {}, to(1e-6)).solve(c.values);
    EXPECT_TRUE(moved.converged);
    const Eigen::VectorXd values = evaluate(triharmonic(), move(c.points), moved.function, move(at));
    EXPECT_LT((values - reference).cwiseAbs().maxCoeff(), 1e-5) << unit;
  }
}

TEST(FastSolver, FourDimensionsInLayers) {
  Eigen::MatrixXd points = random_points(4, 5000, 6);
  for (int i = 0; i < 5000; ++i) points(3, i) = i % 2 ? 100 : 0;
  Eigen::VectorXd values(5000);
  for (int i = 0; i < 5000; ++i) values[i] = 80 - points.col(i).head(3).norm() * (i % 2 ? 1.3 : 1);
  const Solution solution = FastSolver(triharmonic(), points, {}, to(1e-5)).solve(values);
  EXPECT_TRUE(solution.converged) << solution.largest_residual;
}

TEST(FastSolver, StartsFromAnEarlierSolution) {
  const Constraints c = star_contours(6, 2);
  FastSolver solver(biharmonic(), c.points, {}, to(1e-5));
  const Solution cold = solver.solve(c.values);
  const Solution warm = solver.solve(c.values, cold.function.weights);
  EXPECT_TRUE(warm.converged);
  EXPECT_LT(warm.iterations, cold.iterations / 2);
}

TEST(FastSolver, OneAndTwoThreadsGiveTheSameBits) {
  const Constraints c = star_contours(4, 2);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return FastSolver(biharmonic(), c.points, {}, to(1e-5)).solve(c.values).function.weights;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(FastSolver, RefusesWhatDoesNotFitBeforeItStarts) {
  FastSolverOptions options;
  options.memory_limit_bytes = 1'000'000;
  EXPECT_THROW(FastSolver(biharmonic(), random_points(3, 1000, 7), {}, options), SolveError);
}

TEST(FastSolver, CanBeCancelled) {
  const Constraints c = star_contours(2, 2);
  Progress progress;
  progress.is_cancelled = [] { return true; };
  EXPECT_THROW(FastSolver(biharmonic(), c.points, {}, {}, progress), Cancelled);
}

}  // namespace
}  // namespace isostack

#include "recon/solvers/fast_sum.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <random>
#include <string>

#include "recon/solvers/direct_sum.h"
#include "recon/solvers/kernel_operator.h"

namespace isostack {
namespace {

Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-50, 50);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

Eigen::VectorXd random_weights(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(count, [&] { return normal(random); });
}

struct Case {
  std::string kernel;
  int dimension;
};

class FastSumKernels : public testing::TestWithParam<Case> {
 protected:
  Kernel kernel = kernel_named(GetParam().kernel);
  int dimension = GetParam().dimension;
};

// Order 10 interpolates the far field to some 1e-8 of the largest sums; 1e-6 allows for the gradient's h⁻¹.
TEST_P(FastSumKernels, ValuesAndGradientsAgreeWithDirectSums) {
  const Eigen::MatrixXd sources = random_points(dimension, 6000, 1), targets = random_points(dimension, 2000, 2);
  const Eigen::VectorXd weights = random_weights(6000, 3);
  FastSumOptions options;
  options.far_field.order = 10;
  FastSum sum({kernel}, sources, targets, options);
  const RadialSums sums = sum.sums(weights, Derivatives::first);
  const Eigen::VectorXd values = direct_sum(kernel, sources, weights, targets);
  const Eigen::MatrixXd gradients = direct_sum_gradient(kernel, sources, weights, targets);
  EXPECT_LT((sums.values - values).cwiseAbs().maxCoeff(), 1e-6 * values.cwiseAbs().maxCoeff());
  EXPECT_LT((sums.gradients - gradients).cwiseAbs().maxCoeff(), 1e-6 * gradients.cwiseAbs().maxCoeff());
}

// A higher order must pay: the far field really is interpolated, and converges.
TEST_P(FastSumKernels, TheErrorFallsWithTheOrder) {
  const Eigen::MatrixXd points = random_points(dimension, 8000, 4);
  const Eigen::VectorXd weights = random_weights(8000, 5);
  const Eigen::VectorXd exact = direct_sum(kernel, points, weights, points);
  double last = exact.cwiseAbs().maxCoeff();
  for (const int order : {4, 6, 8}) {
    FastSumOptions options;
    options.far_field.order = order;
    options.leaf_size = 40;
    FastSum sum({kernel}, points, options);
    const double error = (sum.values(weights) - exact).cwiseAbs().maxCoeff();
    EXPECT_LT(error, 0.2 * last) << order;
    last = error;
  }
}

TEST_P(FastSumKernels, HessianIsTheGradientsDerivative) {
  const Eigen::MatrixXd sources = random_points(dimension, 4000, 6);
  const Eigen::MatrixXd targets = random_points(dimension, 50, 7);
  const Eigen::VectorXd weights = random_weights(4000, 8);
  FastSumOptions options;
  options.far_field.order = 11;
  const double step = 1e-4;  // central differences: error step² · fourth derivative, far below 1e-4
  const RadialSums at = FastSum({kernel}, sources, targets, options).sums(weights, Derivatives::second);
  const int place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  for (int axis = 0; axis < dimension; ++axis) {
    Eigen::MatrixXd ahead = targets, behind = targets;
    ahead.row(axis).array() += step;
    behind.row(axis).array() -= step;
    const Eigen::MatrixXd slope =
        (direct_sum_gradient(kernel, sources, weights, ahead) - direct_sum_gradient(kernel, sources, weights, behind)) /
        (2 * step);
    for (int other = 0; other < dimension; ++other)
      EXPECT_LT((at.hessians.row(place[axis][other]) - slope.row(other)).cwiseAbs().maxCoeff(),
                2e-4 * at.hessians.cwiseAbs().maxCoeff());
  }
}

TEST_P(FastSumKernels, OneAndTwoThreadsGiveTheSameBits) {
  const Eigen::MatrixXd points = random_points(dimension, 5000, 9);
  const Eigen::VectorXd weights = random_weights(5000, 10);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    FastSum sum({kernel}, points, {});
    return sum.values(weights);
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

INSTANTIATE_TEST_SUITE_P(All, FastSumKernels,
                         testing::Values(Case{"biharmonic", 3}, Case{"thin_plate", 3}, Case{"triharmonic", 3},
                                         Case{"biharmonic", 2}, Case{"thin_plate", 2}, Case{"triharmonic", 2}),
                         [](const auto& one) { return one.param.kernel + std::to_string(one.param.dimension) + "D"; });

// Half of the points within a thousandth of the domain: cells of very different depth meet.
TEST(FastSum, ClustersAreDividedFurther) {
  Eigen::MatrixXd points = random_points(3, 8000, 11);
  points.leftCols(4000) = points.leftCols(4000) * 1e-3;
  const Eigen::VectorXd weights = random_weights(8000, 12);
  FastSumOptions options;
  options.far_field.order = 9;
  FastSum sum({biharmonic()}, points, options);
  const Eigen::VectorXd exact = direct_sum(biharmonic(), points, weights, points);
  EXPECT_LT((sum.values(weights) - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff());
  EXPECT_LT(sum.interactions().near_pairs, 0.5 * 8000.0 * 8000.0);
}

// Two key frames at different t: the shifted kernel √(r² + Δt²) between them.
TEST(KernelOperator, LayersOfAFourDimensionalMorphAgreeWithDirectSums) {
  Eigen::MatrixXd points = random_points(4, 7000, 13);
  for (int i = 0; i < 7000; ++i) points(3, i) = i % 2 ? 30 : 0;
  const Eigen::VectorXd weights = random_weights(7000, 14);
  for (const Kernel& kernel : {biharmonic(), triharmonic()}) {
    FastSumOptions options;
    options.far_field.order = 10;
    KernelOperator sums(kernel, points, options);
    const Eigen::VectorXd exact = direct_sum(kernel, points, weights, points);
    EXPECT_LT((sums.times(weights) - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff());
    const std::vector<std::uint32_t> sample{0, 1, 2, 17, 4000, 5999};
    const Eigen::VectorXd rows = direct_rows(kernel, points, weights, sample);
    for (std::size_t k = 0; k < sample.size(); ++k)
      EXPECT_NEAR(rows[static_cast<Eigen::Index>(k)], exact[sample[k]], 1e-11 * exact.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace isostack

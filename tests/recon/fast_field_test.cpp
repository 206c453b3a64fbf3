#include "recon/solvers/fast_field.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <random>

#include "recon/solvers/direct_sum.h"

namespace isostack {
namespace {

Eigen::MatrixXd cloud(Eigen::Index dimension, Eigen::Index count, double extent, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, extent);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return normal(random); });
}

class FastFieldKernels : public testing::TestWithParam<const char*> {};

TEST_P(FastFieldKernels, BatchesOfAnySizeAgreeWithDirectSums) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1);
  Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  weights.array() -= weights.mean();
  const double scale = direct_sum(kernel, centres, weights, centres.leftCols(100)).cwiseAbs().maxCoeff();
  const FastField field(kernel, centres, weights, {.tolerance = 1e-6 * scale});
  EXPECT_LE(field.sampled_error(), 1e-6 * scale);
  for (const Eigen::Index count : {7, 5000}) {  // below and above the limit of direct sums
    const Eigen::MatrixXd points = cloud(3, count, 40, 3);
    EXPECT_LT((field.values(points) - direct_sum(kernel, centres, weights, points)).cwiseAbs().maxCoeff(),
              1e-5 * scale);
    const Eigen::MatrixXd expected = direct_sum_gradient(kernel, centres, weights, points);
    // Derivatives of an interpolant lose about one order.
    EXPECT_LT((field.gradients(points) - expected).cwiseAbs().maxCoeff(), 1e-3 * expected.cwiseAbs().maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(All, FastFieldKernels, testing::Values("biharmonic", "thin_plate", "triharmonic"));

// The promise of the tolerance, at points the order was not chosen by: near the centres and some way off.
// A sample of 256 may miss the largest error of 1000 others, but hardly by a factor of 2.
TEST_P(FastFieldKernels, TheToleranceHoldsAtOtherPoints) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 20000, 30, 1);
  Eigen::VectorXd weights = cloud(20000, 1, 1e-3, 2);
  weights.array() -= weights.mean();
  const Eigen::MatrixXd points = centres.leftCols(2000) + cloud(3, 2000, 2, 7);
  const Eigen::VectorXd expected = direct_sum(kernel, centres, weights, points);
  const double scale = expected.cwiseAbs().maxCoeff();
  int last_order = 0;
  for (const double tolerance : {1e-3 * scale, 1e-5 * scale, 1e-7 * scale}) {
    const FastField field(kernel, centres, weights, {.tolerance = tolerance});
    EXPECT_LE(field.sampled_error(), tolerance);
    EXPECT_LT((field.values(points) - expected).cwiseAbs().maxCoeff(), 2 * tolerance);
    EXPECT_GE(field.order(), last_order);
    last_order = field.order();
  }
}

// Far fields are kept from batch to batch: neither the batch nor the order of batches may show.
TEST_P(FastFieldKernels, AValueDependsOnItsPointAlone) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 3000, 30, 3);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  const FastField::Options options{.tolerance = 1e-3, .direct_pairs = 0};
  const FastField field(kernel, centres, weights, options), other(kernel, centres, weights, options);
  const RadialSums whole = field.sums(points, Derivatives::first);
  EXPECT_EQ(field.values(points.rightCols(17)), other.values(points.rightCols(17)));
  const RadialSums again = other.sums(points, Derivatives::first);
  // The translations of a first batch may be summed in other company, so to rounding only.
  const double rounding = 1e-12 * weights.cwiseAbs().sum() * kernel.value(200.0 * 200.0);
  EXPECT_LT((whole.values - again.values).cwiseAbs().maxCoeff(), rounding);
  EXPECT_EQ(field.sums(points, Derivatives::first).values, whole.values);
  EXPECT_EQ(field.sums(points, Derivatives::first).gradients, whole.gradients);
}

TEST_P(FastFieldKernels, ForgettingFarFieldsChangesNothing) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 4000, 30, 3);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  const FastField keeping(kernel, centres, weights, {.tolerance = 1e-3}),
      forgetting(kernel, centres, weights, {.tolerance = 1e-3, .kept_bytes = 0});
  for (int batch = 0; batch < 2; ++batch) EXPECT_EQ(keeping.values(points), forgetting.values(points));
}

// Symmetric storage, so the mixed derivatives are checked from both sides: ∂g_x/∂y and ∂g_y/∂x.
TEST_P(FastFieldKernels, HessianIsTheGradientsDerivativeFromBothSides) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 60, 40, 3);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  const FastField field(kernel, centres, weights, {.tolerance = 1e-6, .direct_pairs = 0});
  const Eigen::MatrixXd hessians = field.sums(points, Derivatives::second).hessians;
  const double step = 1e-4;  // differences of direct gradients: error step² · fourth derivative
  const int place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd ahead = points, behind = points;
    ahead.row(axis).array() += step;
    behind.row(axis).array() -= step;
    const Eigen::MatrixXd slope =
        (direct_sum_gradient(kernel, centres, weights, ahead) - direct_sum_gradient(kernel, centres, weights, behind)) /
        (2 * step);
    for (int other = 0; other < 3; ++other)
      EXPECT_LT((hessians.row(place[axis][other]) - slope.row(other)).cwiseAbs().maxCoeff(),
                2e-4 * hessians.cwiseAbs().maxCoeff());
  }
}

TEST_P(FastFieldKernels, OneAndTwoThreadsGiveTheSameBits) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 5000, 40, 3);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return FastField(kernel, centres, weights, {.tolerance = 1e-3}).gradients(points);
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

// No order reaches a tolerance below rounding: the search ends at its best and says so.
TEST_P(FastFieldKernels, AnUnreachableToleranceIsOwnedUpTo) {
  const Kernel kernel = kernel_named(GetParam());
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 5000, 30, 3);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  const FastField field(kernel, centres, weights, {.tolerance = 1e-30});
  EXPECT_GT(field.sampled_error(), 1e-30);
  const Eigen::VectorXd expected = direct_sum(kernel, centres, weights, points);
  EXPECT_LT((field.values(points) - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
}

TEST_P(FastFieldKernels, CentresADistanceOffInAFurtherDimension) {
  const RadialFunction function{kernel_named(GetParam()), 15.0 * 15.0};
  const Eigen::MatrixXd centres = cloud(3, 6000, 30, 1), points = cloud(3, 5000, 40, 3);
  Eigen::VectorXd weights = cloud(6000, 1, 1e-3, 2);
  weights.array() -= weights.mean();
  const RadialSums expected = direct_sums(function, centres, weights, points, Derivatives::first);
  const double scale = expected.values.cwiseAbs().maxCoeff();
  const FastField field(function, centres, weights, {.tolerance = 1e-6 * scale});
  const RadialSums sums = field.sums(points, Derivatives::first);
  EXPECT_LT((sums.values - expected.values).cwiseAbs().maxCoeff(), 1e-5 * scale);
  EXPECT_LT((sums.gradients - expected.gradients).cwiseAbs().maxCoeff(),
            1e-3 * expected.gradients.cwiseAbs().maxCoeff());
}

TEST(FastField, PointsFarOutsideAreSummedToo) {
  const Eigen::MatrixXd centres = cloud(3, 6000, 10, 1), far = cloud(3, 4000, 1e4, 5);
  const Eigen::VectorXd weights = cloud(6000, 1, 1, 2);
  const FastField field(biharmonic(), centres, weights, {});
  const Eigen::VectorXd expected = direct_sum(biharmonic(), centres, weights, far);
  EXPECT_LT((field.values(far) - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST(FastField, CentresInAPlaneServePointsOutsideIt) {
  Eigen::MatrixXd centres = cloud(3, 6000, 10, 1);
  centres.row(2).setConstant(4);
  const Eigen::VectorXd weights = cloud(6000, 1, 1e-2, 2);
  const Eigen::MatrixXd points = cloud(3, 5000, 10, 3);
  const Eigen::VectorXd expected = direct_sum(biharmonic(), centres, weights, points);
  const FastField field(biharmonic(), centres, weights, {.tolerance = 1e-4});
  EXPECT_LT((field.values(points) - expected).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace isostack

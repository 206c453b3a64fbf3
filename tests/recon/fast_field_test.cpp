#include "recon/solvers/fast_field.h"

#include <gtest/gtest.h>

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

#include "recon/solvers/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// Well conditioned: the identity plus a product of two random matrices.
Eigen::MatrixXd positive_definite(Eigen::Index count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(count, count, [&] { return normal(random); });
  return Eigen::MatrixXd::Identity(count, count) + half * half.transpose() / static_cast<double>(count);
}

TEST(Cholesky, FactorsMatricesOfOneAndOfManyPanels) {
  for (const Eigen::Index count : {1, 100, 128, 129, 700}) {
    const Eigen::MatrixXd matrix = positive_definite(count);
    Eigen::MatrixXd factor = matrix;
    ASSERT_TRUE(cholesky_in_place(factor));
    const Eigen::MatrixXd lower = factor.triangularView<Eigen::Lower>();
    EXPECT_LT((lower * lower.transpose() - matrix).norm(), 1e-13 * matrix.norm());  // rounding
  }
}

TEST(Cholesky, FactorsABlockOfALargerMatrix) {
  const Eigen::MatrixXd matrix = positive_definite(300);
  Eigen::MatrixXd outer = Eigen::MatrixXd::Constant(310, 310, 5);
  outer.bottomRightCorner(300, 300) = matrix;
  ASSERT_TRUE(cholesky_in_place(outer.bottomRightCorner(300, 300)));
  const Eigen::MatrixXd expected = matrix.llt().matrixL();
  const Eigen::MatrixXd lower = outer.bottomRightCorner(300, 300).triangularView<Eigen::Lower>();
  EXPECT_LT((lower - expected).norm(), 1e-13 * expected.norm());
  EXPECT_TRUE((outer.leftCols(10).array() == 5).all());
}

TEST(Cholesky, TellsWhatIsNotPositiveDefinite) {
  Eigen::MatrixXd matrix = positive_definite(300);
  matrix(250, 250) = -1;
  EXPECT_FALSE(cholesky_in_place(matrix));
}

TEST(Cholesky, ReportsAndStopsOnTheWay) {
  std::vector<double> fractions;
  Progress progress;
  progress.on_report = [&](std::string_view, double fraction) { fractions.push_back(fraction); };
  progress.is_cancelled = [&] { return fractions.size() == 3; };
  Eigen::MatrixXd matrix = positive_definite(700);
  EXPECT_THROW(cholesky_in_place(matrix, progress), Cancelled);
  ASSERT_EQ(fractions.size(), 3U);
  EXPECT_LT(fractions.back(), 1);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

}  // namespace
}  // namespace isostack

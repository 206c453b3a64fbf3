#include "recon/kernels/polynomial.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace isostack {
namespace {

/// Points as far from the origin as a scanner's table may be.
Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(900, 1100);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

TEST(PolynomialBasis, HasBinomialSize) {
  EXPECT_EQ(PolynomialBasis(0, random_points(3, 10, 1)).size(), 1);
  EXPECT_EQ(PolynomialBasis(1, random_points(3, 10, 1)).size(), 4);
  EXPECT_EQ(PolynomialBasis(2, random_points(3, 20, 1)).size(), 10);
  EXPECT_EQ(PolynomialBasis(3, random_points(2, 20, 1)).size(), 10);
  EXPECT_EQ(PolynomialBasis(1, random_points(6, 20, 1)).size(), 7);
}

TEST(PolynomialBasis, SpansTheQuadraticsInWorldCoordinates) {
  const Eigen::MatrixXd points = random_points(3, 60, 2), elsewhere = random_points(3, 25, 3);
  const auto quadratic = [](const Eigen::MatrixXd& at) -> Eigen::VectorXd {
    const Eigen::ArrayXXd p = at.array() - 1000;
    return (2 - 3 * p.row(0) + p.row(1) * p.row(2) - 0.5 * p.row(2).square()).matrix().transpose();
  };
  const PolynomialBasis basis(2, points);
  const Eigen::VectorXd coefficients = basis.values(points).colPivHouseholderQr().solve(quadratic(points));
  // Values reach 10⁴; a fit through well conditioned monomials keeps ten digits.
  EXPECT_LT((basis.values(elsewhere) * coefficients - quadratic(elsewhere)).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(PolynomialBasis, StaysWellConditionedFarFromTheOriginAndInAnyUnit) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const Eigen::MatrixXd points = unit * random_points(3, 80, 4);
    const Eigen::VectorXd singular = PolynomialBasis(2, points).values(points).jacobiSvd().singularValues();
    EXPECT_LT(singular[0] / singular[singular.size() - 1], 100) << "unit " << unit;
  }
}

TEST(PolynomialBasis, GradientsAgreeWithFiniteDifferences) {
  for (const int dimension : {1, 3, 6}) {
    const Eigen::MatrixXd points = random_points(dimension, 30, 5);
    const PolynomialBasis basis(3, points);
    const Eigen::VectorXd coefficients = Eigen::VectorXd::LinSpaced(basis.size(), -1, 2);
    const Eigen::MatrixXd gradients = basis.gradients(points, coefficients);
    const double step = 1e-3;  // error step² · third derivative ~ 1e-6 · 1e-4; rounding 1e-13 / step
    for (int axis = 0; axis < dimension; ++axis) {
      Eigen::MatrixXd ahead = points, behind = points;
      ahead.row(axis).array() += step;
      behind.row(axis).array() -= step;
      const Eigen::VectorXd difference = (basis.values(ahead) - basis.values(behind)) * coefficients / (2 * step);
      EXPECT_LT((gradients.row(axis).transpose() - difference).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

TEST(PolynomialBasis, OfOnePointIsUsable) {
  const Eigen::MatrixXd point = Eigen::Vector3d(4, 5, 6);
  const Eigen::MatrixXd values = PolynomialBasis(1, point).values(point);
  EXPECT_TRUE(values.allFinite());
  EXPECT_EQ(values(0, 0), 1);
}

}  // namespace
}  // namespace isostack

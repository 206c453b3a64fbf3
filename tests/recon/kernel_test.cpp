#include "recon/kernels/kernel.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/kernels/polynomial.h"

namespace isostack {
namespace {

Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

std::vector<Kernel> some_kernels() {
  std::vector<Kernel> kernels = {biharmonic(), thin_plate(), triharmonic()};
  for (int dimension = 1; dimension <= 6; ++dimension)
    for (int order = dimension / 2 + 1; order <= dimension / 2 + 3; ++order)
      kernels.push_back(duchon(dimension, order));
  return kernels;
}

TEST(Kernel, ValuesAreTheNamedFunctions) {
  for (const double r : {0.01, 0.5, 1.0, 7.3}) {
    EXPECT_DOUBLE_EQ(biharmonic().value(r * r), r);
    EXPECT_NEAR(thin_plate().value(r * r), r * r * std::log(r), 1e-14 * (1 + r * r));
    EXPECT_NEAR(triharmonic().value(r * r), r * r * r, 1e-14 * (1 + r * r * r));
  }
}

TEST(Kernel, EverythingVanishesAtZero) {
  for (const Kernel& kernel : some_kernels()) {
    EXPECT_EQ(kernel.value(0), 0) << kernel.name();
    EXPECT_EQ(kernel.slope_over_distance(0), 0) << kernel.name();
    EXPECT_EQ(kernel.curvature_factor(0), 0) << kernel.name();
  }
}

TEST(Kernel, DerivativeFactorsAgreeWithFiniteDifferences) {
  for (const Kernel& kernel : some_kernels())
    for (const double r : {0.3, 1.0, 2.5}) {
      const double h = 1e-4;
      const auto phi = [&](double at) { return kernel.value(at * at); };
      const auto slope = [&](double at) { return kernel.slope_over_distance(at * at); };
      // Central differences are off by h²/6 times the third derivative: below 1e-8 of the scale times power³.
      const double scale = (1 + std::pow(r, kernel.power)) * std::pow(kernel.power + 4, 3) / std::pow(r, 4);
      EXPECT_NEAR(slope(r), (phi(r + h) - phi(r - h)) / (2 * h) / r, 1e-8 * scale) << kernel.name() << " at " << r;
      EXPECT_NEAR(kernel.curvature_factor(r * r), (slope(r + h) - slope(r - h)) / (2 * h) / r, 1e-7 * scale)
          << kernel.name() << " at " << r;
    }
}

/// sign · φ on the weights that annihilate the tail has only positive eigenvalues.
void expect_definite(const Kernel& kernel, int dimension) {
  const Eigen::MatrixXd points = random_points(dimension, 70, 7);
  const Eigen::Index n = points.cols();
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      matrix(i, j) = kernel.sign() * kernel.value((points.col(i) - points.col(j)).squaredNorm());
  const Eigen::MatrixXd tail = PolynomialBasis(kernel.tail_degree, points).values(points);
  ASSERT_LT(tail.cols(), n) << "too few points to say anything";
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(tail).householderQ();
  const Eigen::MatrixXd free = q.rightCols(n - tail.cols());
  const Eigen::VectorXd spectrum =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(free.transpose() * matrix * free).eigenvalues();
  // Smooth kernels have tiny eigenvalues; anything truly negative is far above the rounding of the largest.
  EXPECT_GT(spectrum.minCoeff(), -1e-13 * spectrum.maxCoeff()) << kernel.name() << " in " << dimension << "D";
  EXPECT_GT(spectrum.maxCoeff(), 0) << kernel.name() << " in " << dimension << "D";
}

TEST(Kernel, SignMakesTheProjectedMatrixPositiveDefinite) {
  for (const Kernel& kernel : {biharmonic(), thin_plate(), triharmonic()})
    for (int dimension = 1; dimension <= 6; ++dimension) expect_definite(kernel, dimension);
}

TEST(Kernel, DuchonSplinesAreDefiniteInTheirDimension) {
  for (int dimension = 1; dimension <= 6; ++dimension)
    for (int order = dimension / 2 + 1; order <= std::min(4, dimension / 2 + 2); ++order) {
      if (dimension >= 5 && order == 4) continue;  // as many polynomials as points here
      expect_definite(duchon(dimension, order), dimension);
    }
}

TEST(Duchon, GivesTheKnownSplines) {
  EXPECT_EQ(duchon(2, 2).name(), "thin_plate");
  EXPECT_EQ(duchon(3, 2).name(), "biharmonic");
  EXPECT_EQ(duchon(1, 2).name(), "triharmonic");  // the cubic spline
  EXPECT_EQ(duchon(3, 3).name(), "triharmonic");
  EXPECT_EQ(duchon(3, 3).tail_degree, 2);
  EXPECT_EQ(duchon(2, 3).name(), "r^4 log r");
  EXPECT_EQ(duchon(3, 4).name(), "r^5");
}

TEST(Duchon, RefusesOrdersThatGiveNoContinuousSpline) {
  EXPECT_THROW(duchon(2, 1), InputError);
  EXPECT_THROW(duchon(4, 2), InputError);
  EXPECT_THROW(duchon(6, 3), InputError);
  EXPECT_NO_THROW(duchon(1, 1));
}

TEST(KernelNamed, FindsTheThreeAndNamesAnythingElse) {
  for (const Kernel& kernel : {biharmonic(), thin_plate(), triharmonic()}) {
    const Kernel found = kernel_named(kernel.name());
    EXPECT_EQ(found.power, kernel.power);
    EXPECT_EQ(found.logarithmic, kernel.logarithmic);
  }
  try {
    kernel_named("gaussian");
    FAIL() << "gaussian is no kernel";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gaussian"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("thin_plate"), std::string::npos);
  }
}

}  // namespace
}  // namespace isostack

#include "recon/surface/layered_function.h"

#include <gtest/gtest.h>

#include <random>

#include "recon/geometry/errors.h"
#include "recon/solvers/direct_sum.h"

namespace isostack {
namespace {

struct Interpolant {
  Eigen::MatrixXd centres;
  RadialWeights solution;
};

/// Random centres in layers: at each of `places` (m × layers) `per_layer` points of three more coordinates.
Interpolant in_layers(const Eigen::MatrixXd& places, Eigen::Index per_layer) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 20);
  Interpolant result;
  result.centres.resize(3 + places.rows(), per_layer * places.cols());
  for (Eigen::Index i = 0; i < result.centres.cols(); ++i)
    result.centres.col(i) << normal(random), normal(random), normal(random), places.col(i % places.cols());
  auto weights = Eigen::VectorXd::NullaryExpr(result.centres.cols(), [&] { return 1e-5 * normal(random); });
  result.solution.weights = weights;
  result.solution.weights.array() -= result.solution.weights.mean();
  result.solution.tail = PolynomialBasis(1, result.centres);
  result.solution.tail_coefficients = Eigen::VectorXd::LinSpaced(result.solution.tail.size(), -1, 2);
  return result;
}

struct Case {
  const char* kernel;
  Eigen::Index further, layers, per_layer;
};

class LayeredFunctions : public testing::TestWithParam<Case> {};

TEST_P(LayeredFunctions, SectionsAgreeWithDirectSumsInAllDimensions) {
  const Case& c = GetParam();
  const Kernel kernel = kernel_named(c.kernel);
  const Eigen::MatrixXd places =
      40 * Eigen::MatrixXd::NullaryExpr(c.further, c.layers, [](Eigen::Index i, Eigen::Index j) {
        return i + 1 == j ? 1.0 : 0.0;  // corners of a simplex
      });
  const Interpolant given = in_layers(places, c.per_layer);
  const LayeredFunction function(kernel, given.centres, given.solution);
  EXPECT_EQ(function.dimension(), 3 + c.further);
  const Eigen::VectorXd place = places.rowwise().mean() + Eigen::VectorXd::Constant(c.further, 3.0);

  constexpr Eigen::Index count = 6000;  // more pairs than are summed term by term
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-50, 50);
  Eigen::MatrixXd points(3 + c.further, count);
  for (Eigen::Index i = 0; i < count; ++i) points.col(i) << uniform(random), uniform(random), uniform(random), place;
  const RadialSums sums = direct_sums(kernel, given.centres, given.solution.weights, points, Derivatives::first);
  const Eigen::VectorXd values = sums.values + given.solution.tail.values(points) * given.solution.tail_coefficients;
  const Eigen::Matrix3Xd gradients =
      (sums.gradients + given.solution.tail.gradients(points, given.solution.tail_coefficients)).topRows(3);

  const double scale = values.cwiseAbs().maxCoeff(), tolerance = 1e-6 * scale;
  const ScalarField section = function.section(place, tolerance);
  const Eigen::Matrix3Xd in_space = points.topRows(3);
  // The tolerance holds at a sample near the centres; here points are up to twice as far out.
  EXPECT_LT((section.values(in_space) - values).cwiseAbs().maxCoeff(), 10 * tolerance);
  EXPECT_LT((section.gradients(in_space) - gradients).cwiseAbs().maxCoeff(), 1e-3 * gradients.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Kernels, LayeredFunctions,
                         testing::Values(Case{"triharmonic", 1, 2, 4000}, Case{"biharmonic", 1, 2, 4000},
                                         Case{"thin_plate", 1, 2, 4000}, Case{"triharmonic", 2, 3, 3500},
                                         Case{"triharmonic", 3, 4, 500}, Case{"triharmonic", 0, 1, 4000}));

// One layer fills a fiftieth of what the other fills, at its rim: its fast sums must reach all over it.
TEST(LayeredFunction, LayersMayBeOfOtherSizesAndPlaces) {
  Interpolant given = in_layers(Eigen::RowVector2d(0, 40), 4000);
  for (Eigen::Index i = 1; i < given.centres.cols(); i += 2)
    given.centres.col(i).head(3) = Eigen::Vector3d(60, 0, 0) + 0.02 * given.centres.col(i).head(3);
  const LayeredFunction function(triharmonic(), given.centres, given.solution);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-70, 70);
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::NullaryExpr(3, 6000, [&] { return uniform(random); });
  Eigen::MatrixXd lifted(4, points.cols());
  lifted << points, Eigen::RowVectorXd::Constant(points.cols(), 10.0);
  const Eigen::VectorXd expected = direct_sum(triharmonic(), given.centres, given.solution.weights, lifted) +
                                   given.solution.tail.values(lifted) * given.solution.tail_coefficients;
  const double tolerance = 1e-6 * expected.cwiseAbs().maxCoeff();
  const Eigen::VectorXd values = function.section(Eigen::VectorXd::Constant(1, 10.0), tolerance).values(points);
  EXPECT_LT((values - expected).cwiseAbs().maxCoeff(), 100 * tolerance);  // far from the centres errors grow like r³
}

TEST(LayeredFunction, ASectionOutlivesTheFunction) {
  const Interpolant given = in_layers(Eigen::RowVector2d(0, 40), 50);
  ScalarField section;
  {
    const LayeredFunction function(triharmonic(), given.centres, given.solution);
    section = function.section(Eigen::VectorXd::Constant(1, 10.0));
  }
  const Eigen::Matrix3Xd origin = Eigen::Matrix3Xd::Zero(3, 1);
  const Eigen::MatrixXd lifted = Eigen::Vector4d(0, 0, 0, 10);
  const double expected = direct_sum(triharmonic(), given.centres, given.solution.weights, lifted)[0] +
                          (given.solution.tail.values(lifted) * given.solution.tail_coefficients)[0];
  EXPECT_NEAR(section.values(origin)[0], expected, 1e-9 * std::abs(expected));
}

TEST(LayeredFunction, WhatHasNoSectionIsRefused) {
  const Interpolant given = in_layers(Eigen::RowVector2d(0, 40), 50);
  const LayeredFunction function(triharmonic(), given.centres, given.solution);
  EXPECT_THROW(function.section(Eigen::VectorXd::Zero(2)), InputError);
  const Interpolant scattered = in_layers(Eigen::RowVectorXd::LinSpaced(40, 0, 1), 1);
  EXPECT_THROW(LayeredFunction(triharmonic(), scattered.centres, scattered.solution), InputError);
  EXPECT_THROW(LayeredFunction(triharmonic(), Eigen::MatrixXd::Zero(2, 5), given.solution), InputError);
}

}  // namespace
}  // namespace isostack

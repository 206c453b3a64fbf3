#include "recon/solvers/dense_solver.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <random>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/surface/implicit_function.h"

namespace isostack {
namespace {

Eigen::MatrixXd random_points(int dimension, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-50, 50);
  return Eigen::MatrixXd::NullaryExpr(dimension, count, [&] { return uniform(random); });
}

Eigen::VectorXd wavy_values(const Eigen::MatrixXd& points) {
  return (points.colwise().sum().array() * 0.05).sin().matrix().transpose();
}

struct Case {
  std::string name;
  Kernel kernel;
  int dimension;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class DenseSolverKernels : public testing::TestWithParam<Case> {};

TEST_P(DenseSolverKernels, InterpolatesAndAnnihilatesPolynomials) {
  const auto [name, kernel, dimension] = GetParam();
  const Eigen::MatrixXd points = random_points(dimension, 300, 1);
  const Eigen::VectorXd values = wavy_values(points);
  const DenseSolver solver(kernel, points, {}, {});
  const RadialWeights solution = solver.solve(values);
  const ImplicitFunction f(kernel, points, solution);
  EXPECT_LT((f.values(points) - values).cwiseAbs().maxCoeff(), 1e-8);
  const PolynomialBasis basis(kernel.tail_degree, points);
  const Eigen::VectorXd moments = basis.values(points).transpose() * solution.weights;
  EXPECT_LT(moments.norm(), 1e-9 * solution.weights.norm() * 300);
}

TEST_P(DenseSolverKernels, ReproducesItsPolynomials) {
  const auto [name, kernel, dimension] = GetParam();
  const Eigen::MatrixXd points = random_points(dimension, 120, 2), elsewhere = random_points(dimension, 40, 3);
  const PolynomialBasis basis(kernel.tail_degree, points);
  const Eigen::VectorXd coefficients = Eigen::VectorXd::LinSpaced(basis.size(), -1, 2);
  const DenseSolver solver(kernel, points, {}, {});
  const ImplicitFunction f(kernel, points, solver.solve(basis.values(points) * coefficients));
  EXPECT_LT((f.values(elsewhere) - basis.values(elsewhere) * coefficients).cwiseAbs().maxCoeff(), 1e-7);
}

TEST_P(DenseSolverKernels, GradientAgreesWithFiniteDifferences) {
  const auto [name, kernel, dimension] = GetParam();
  const Eigen::MatrixXd points = random_points(dimension, 150, 4), elsewhere = random_points(dimension, 20, 5);
  const DenseSolver solver(kernel, points, {}, {});
  const ImplicitFunction f(kernel, points, solver.solve(wavy_values(points)));
  const Eigen::MatrixXd gradients = f.gradients(elsewhere);
  const double step = 1e-4;
  for (int axis = 0; axis < dimension; ++axis) {
    Eigen::MatrixXd ahead = elsewhere, behind = elsewhere;
    ahead.row(axis).array() += step;
    behind.row(axis).array() -= step;
    const Eigen::VectorXd slope = (f.values(ahead) - f.values(behind)) / (2 * step);
    // Second order differences: the third derivative is of order 1e-2 here.
    EXPECT_LT((slope.transpose() - gradients.row(axis)).cwiseAbs().maxCoeff(), 1e-6) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, DenseSolverKernels,
                         testing::Values(Case{"r_2D", biharmonic(), 2}, Case{"r_3D", biharmonic(), 3},
                                         Case{"r2logr_2D", thin_plate(), 2}, Case{"r2logr_3D", thin_plate(), 3},
                                         Case{"r3_3D", triharmonic(), 3}, Case{"r3_4D", triharmonic(), 4},
                                         Case{"r3_5D", triharmonic(), 5}, Case{"duchon_3D", duchon(3, 3), 3},
                                         Case{"duchon_4D", duchon(4, 3), 4}, Case{"duchon_1D", duchon(1, 2), 1}),
                         [](const auto& one) { return one.param.name; });

TEST(DenseSolver, SameBitsWithAnyNumberOfThreads) {
  const Eigen::MatrixXd points = random_points(3, 900, 6);  // several panels and tiles
  const Eigen::VectorXd values = wavy_values(points);
  std::vector<Eigen::VectorXd> weights;
  for (const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    weights.push_back(DenseSolver(triharmonic(), points, {}, {}).solve(values).weights);
  }
  EXPECT_TRUE(weights[0] == weights[1]);
  EXPECT_TRUE(weights[0] == weights[2]);
}

TEST(DenseSolver, CubicSplineIsTheOneDimensionalCase) {
  // r³ in 1D is the natural cubic spline: through (0,0), (1,1), (2,0) it has the value 11/16 at 1/2.
  Eigen::MatrixXd points(1, 3);
  points << 0, 1, 2;
  const Eigen::Vector3d values(0, 1, 0);
  const DenseSolver solver(duchon(1, 2), points, {}, {});
  const ImplicitFunction f(duchon(1, 2), points, solver.solve(values));
  EXPECT_NEAR(f.values(Eigen::MatrixXd::Constant(1, 1, 0.5))[0], 11.0 / 16, 1e-12);
}

TEST(DenseSolver, SmoothingLeavesTheResidualRhoTimesWeight) {
  const Eigen::MatrixXd points = random_points(3, 200, 6);
  const Eigen::VectorXd values = wavy_values(points), smoothing = Eigen::VectorXd::LinSpaced(200, 0, 30);
  const Kernel kernel = triharmonic();
  const RadialWeights solution = DenseSolver(kernel, points, smoothing, {}).solve(values);
  const Eigen::VectorXd misfit = values - ImplicitFunction(kernel, points, solution).values(points);
  EXPECT_LT((misfit - kernel.sign() * smoothing.cwiseProduct(solution.weights)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT(misfit.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(DenseSolver, PointsInOnePlaneAreSolved) {
  Eigen::MatrixXd points = random_points(3, 100, 7);
  points.row(2).setConstant(12);
  const Eigen::VectorXd values = wavy_values(points);
  const ImplicitFunction f(triharmonic(), points, DenseSolver(triharmonic(), points, {}, {}).solve(values));
  EXPECT_LT((f.values(points) - values).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(DenseSolver, FarFromTheOriginAndInOtherUnitsTheFunctionIsTheSame) {
  const Eigen::MatrixXd points = random_points(3, 150, 8), elsewhere = random_points(3, 30, 9);
  const Eigen::VectorXd values = wavy_values(points);
  const Kernel kernel = triharmonic();
  const Eigen::VectorXd expected =
      ImplicitFunction(kernel, points, DenseSolver(kernel, points, {}, {}).solve(values)).values(elsewhere);
  const Eigen::Vector3d shift(2e4, -1e4, 3e4);
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const Eigen::MatrixXd moved = ((points.colwise() + shift) * unit), probes = ((elsewhere.colwise() + shift) * unit);
    const ImplicitFunction f(kernel, moved, DenseSolver(kernel, moved, {}, {}).solve(values));
    EXPECT_LT((f.values(probes) - expected).cwiseAbs().maxCoeff(), 1e-6) << unit;
  }
}

TEST(DenseSolver, RefusesWhatDoesNotFitBeforeAllocating) {
  const Eigen::MatrixXd points = random_points(3, 2000, 10);
  try {
    DenseSolver(triharmonic(), points, {}, {.memory_limit_bytes = 1'000'000});
    FAIL() << "2,000 constraints need 33 MB";
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("2000 constraints"), std::string::npos);
  }
}

TEST(DenseSolver, CoincidingPointsAreNamed) {
  Eigen::MatrixXd points = random_points(3, 50, 11);
  points.col(49) = points.col(0);
  EXPECT_THROW(DenseSolver(triharmonic(), points, {}, {}), SolveError);
}

}  // namespace
}  // namespace isostack

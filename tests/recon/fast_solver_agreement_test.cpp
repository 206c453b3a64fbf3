// The fast solver against the dense one: |f_fast − f_dense| stays within ten times the residual asked for, not only
// at the constraints but anywhere around them.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "recon/solvers/dense_solver.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/fast_solver.h"
#include "tests/benchmarks/star_stack.h"

namespace isostack {
namespace {

constexpr double requested_residual = 1e-5;

Eigen::VectorXd evaluate(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& f,
                         const Eigen::MatrixXd& at) {
  return direct_sum(kernel, centres, f.weights, at) + f.tail.values(at) * f.tail_coefficients;
}

/// Uniform in the points' box, enlarged by a fifth of its size on every side.
Eigen::MatrixXd points_around(const Eigen::MatrixXd& points, Eigen::Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.2, 1.2);
  const Eigen::VectorXd least = points.rowwise().minCoeff(), size = points.rowwise().maxCoeff() - least;
  const Eigen::MatrixXd unit = Eigen::MatrixXd::NullaryExpr(points.rows(), count, [&] { return uniform(random); });
  return (size.asDiagonal() * unit).colwise() + least;
}

struct Case {
  std::string kernel;
  int slices;
  double spacing_mm;
  Eigen::Index count;  ///< the first so many of the stack's constraints
  bool smoothed;

  std::string name() const { return kernel + "_" + std::to_string(count) + (smoothed ? "_smoothed" : ""); }
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name(); }

class FastSolverAgreement : public testing::TestWithParam<Case> {};

TEST_P(FastSolverAgreement, WithTheDenseSolver) {
  const Case& c = GetParam();
  const benchmarks::StarStack stack = benchmarks::star_stack(c.slices, c.spacing_mm);
  ASSERT_GE(stack.values.size(), c.count);
  const Eigen::MatrixXd points = stack.points.leftCols(c.count);
  const Eigen::VectorXd values = stack.values.head(c.count);
  Eigen::VectorXd smoothing;
  if (c.smoothed) {  // none to plenty, another for each constraint
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    smoothing = Eigen::VectorXd::NullaryExpr(c.count, [&] { return std::max(0.0, uniform(random) - 0.3); });
  }
  const Kernel kernel = kernel_named(c.kernel);
  FastSolverOptions options;
  options.tolerance = requested_residual;
  const Solution fast = FastSolver(kernel, points, smoothing, options).solve(values);
  EXPECT_TRUE(fast.converged) << fast.largest_residual << ": " << fast.remark;
  const RadialWeights dense = DenseSolver(kernel, points, smoothing, {}).solve(values);
  const Eigen::MatrixXd at = points_around(points, 10'000, 1);
  const Eigen::VectorXd difference = evaluate(kernel, points, fast.function, at) - evaluate(kernel, points, dense, at);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 10 * requested_residual);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string kernel : {"biharmonic", "thin_plate", "triharmonic"})
    for (const bool smoothed : {false, true}) {
      all.push_back({kernel, 3, 2, 2000, smoothed});
      all.push_back({kernel, 6, 2, 4000, smoothed});
    }
  all.push_back({"triharmonic", 6, 1, 8000, false});  // the dense solve of 8,000 takes seconds: the hardest kernel only
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, FastSolverAgreement, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name(); });

}  // namespace
}  // namespace isostack

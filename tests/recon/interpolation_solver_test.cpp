#include "recon/solvers/interpolation_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/solvers/direct_sum.h"
#include "tests/benchmarks/star_stack.h"

namespace isostack {
namespace {

using benchmarks::star_stack;
using benchmarks::StarStack;

ConstraintSet constraint_set(const StarStack& stack) { return {stack.points, stack.values, {}}; }

Eigen::VectorXd evaluate(const InterpolationSolver& solver, const RadialWeights& f, const Eigen::MatrixXd& at) {
  return direct_sum(triharmonic(), solver.merged().set.points, f.weights, at) + f.tail.values(at) * f.tail_coefficients;
}

/// The set with its first `count` constraints once more, their values changed by `change`.
ConstraintSet with_duplicates(const ConstraintSet& set, Eigen::Index count, double shift_mm, double change) {
  ConstraintSet more;
  more.points.resize(3, set.points.cols() + count);
  more.points << set.points, set.points.leftCols(count).array() + shift_mm;
  more.values.resize(more.points.cols());
  more.values << set.values, set.values.head(count).array() + change;
  return more;
}

class InterpolationSolverChoices : public testing::TestWithParam<SolverChoice> {
 protected:
  InterpolationOptions options() const {
    InterpolationOptions options;
    options.solver = GetParam();
    options.tolerance = 1e-6;
    options.merge_distance = 1e-6;
    return options;
  }
};

TEST_P(InterpolationSolverChoices, DuplicatesThatAgreeChangeNothing) {
  const ConstraintSet once = constraint_set(star_stack(3, 2));
  InterpolationSolver reference(once, options());
  SolveReport report;
  const Eigen::MatrixXd at = once.points.leftCols(200).array() + 2;
  const Eigen::VectorXd expected = evaluate(reference, reference.solve(once.values, {}, report), at);
  for (const double shift_mm : {0.0, 1e-9}) {
    const ConstraintSet twice = with_duplicates(once, 100, shift_mm, 0);
    InterpolationSolver solver(twice, options());
    EXPECT_EQ(solver.merged().set.values.size(), once.values.size());
    EXPECT_EQ(solver.merged().largest_contradiction, 0);
    const RadialWeights solution = solver.solve(twice.values, {}, report);
    EXPECT_TRUE(report.converged) << report.remark;
    EXPECT_LT((evaluate(solver, solution, at) - expected).cwiseAbs().maxCoeff(), 1e-9) << shift_mm;
  }
}

TEST_P(InterpolationSolverChoices, DuplicatesThatContradictAreAveragedAndReported) {
  const ConstraintSet once = constraint_set(star_stack(3, 2));
  const ConstraintSet twice = with_duplicates(once, 10, 0, 0.5);
  InterpolationSolver solver(twice, options());
  EXPECT_EQ(solver.merged().largest_contradiction, 0.5);
  SolveReport report;
  const RadialWeights solution = solver.solve(twice.values, {}, report);
  EXPECT_TRUE(report.converged) << report.remark;
  const Eigen::VectorXd averaged = once.values.head(10).array() + 0.25;
  EXPECT_LT((evaluate(solver, solution, once.points.leftCols(10)) - averaged).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_P(InterpolationSolverChoices, TheReportTellsTimeMemoryAndResidual) {
  const ConstraintSet set = constraint_set(star_stack(3, 2));
  InterpolationSolver solver(set, options());
  SolveReport first, second;
  const RadialWeights solution = solver.solve(set.values, {}, first);
  const Eigen::VectorXd misfit = evaluate(solver, solution, set.points) - set.values;
  EXPECT_NEAR(first.largest_residual, misfit.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(first.tolerance, 1e-6);
  EXPECT_EQ(first.predicted_bytes, solver.predicted_bytes());
  std::size_t held_bytes = 0;
  for (const SolveStage& stage : first.stages) {
    EXPECT_FALSE(stage.name.empty());
    EXPECT_GE(stage.seconds, 0);
    held_bytes += stage.bytes;
  }
  EXPECT_GT(held_bytes, 8u * set.points.cols());          // at least the weights
  EXPECT_LT(held_bytes, 1.2 * solver.predicted_bytes());  // the prediction is what the limit is compared with
  EXPECT_EQ(first.stages.back().name, "solve");
  const bool fast = GetParam() == SolverChoice::fast;
  EXPECT_EQ(first.solver, fast ? "fast" : "dense");
  EXPECT_EQ(first.iterations > 0, fast);
  EXPECT_EQ(first.sweeps > 0, fast);
  solver.solve(2 * set.values, {}, second);
  ASSERT_EQ(second.stages.size(), 1u);  // the solver was built once
  EXPECT_EQ(second.stages.front().name, "solve");
}

TEST_P(InterpolationSolverChoices, PointsNoKernelCanTellApartAreMergedUnasked) {
  const ConstraintSet twice = with_duplicates(constraint_set(star_stack(3, 2)), 20, 1e-9, 1);
  InterpolationOptions unasked = options();
  unasked.merge_distance = 0;
  InterpolationSolver solver(twice, unasked);
  EXPECT_EQ(solver.merged().set.values.size(), twice.values.size() - 20);
  EXPECT_EQ(solver.merged().largest_contradiction, 1);
  SolveReport report;
  solver.solve(twice.values, {}, report);
  EXPECT_TRUE(report.converged) << report.remark;
}

TEST_P(InterpolationSolverChoices, AStrayPointDoesNotMergeTheOthers) {
  ConstraintSet set = constraint_set(star_stack(2, 3));
  set.points(0, 7) = 1e9;
  InterpolationOptions unasked = options();
  unasked.merge_distance = 0;
  unasked.kernel = biharmonic();  // r keeps its digits over such an extent
  EXPECT_EQ(InterpolationSolver(set, unasked).merged().set.values.size(), set.values.size());
}

TEST_P(InterpolationSolverChoices, NumbersThatAreNoneAreRefused) {
  const ConstraintSet good = constraint_set(star_stack(2, 3));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    ConstraintSet point = good, value = good;
    point.points(1, 5) = value.values[5] = bad;
    for (const ConstraintSet& set : {point, value}) {
      try {
        const InterpolationSolver solver(set, options());
        FAIL() << bad;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("number 6 of"), std::string::npos) << error.what();
      }
    }
    SolveReport report;
    EXPECT_THROW(InterpolationSolver(good, options()).solve(value.values, {}, report), InputError);
  }
  EXPECT_THROW(InterpolationSolver({Eigen::MatrixXd(3, 0), {}, {}}, options()), InputError);
}

// r³ over 10⁹ mm leaves no digits for points a few mm apart.
TEST_P(InterpolationSolverChoices, AMissedToleranceIsToldByBothSolvers) {
  ConstraintSet set = constraint_set(star_stack(2, 3));
  set.points(0, 7) = 1e9;
  SolveReport report;
  try {
    InterpolationSolver(set, options()).solve(set.values, {}, report);
    EXPECT_EQ(report.converged, report.largest_residual <= report.tolerance);
    EXPECT_EQ(report.converged, report.remark.empty());
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("singular"), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Both, InterpolationSolverChoices, testing::Values(SolverChoice::dense, SolverChoice::fast),
                         [](const auto& one) { return one.param == SolverChoice::fast ? "fast" : "dense"; });

TEST(InterpolationSolver, ManyConstraintsAreSolvedFast) {
  EXPECT_FALSE(InterpolationSolver::uses_fast(SolverChoice::automatic, 2'000));
  EXPECT_TRUE(InterpolationSolver::uses_fast(SolverChoice::automatic, 50'000));
  EXPECT_TRUE(InterpolationSolver::uses_fast(SolverChoice::fast, 10));
  EXPECT_FALSE(InterpolationSolver::uses_fast(SolverChoice::dense, 50'000));
}

TEST(InterpolationSolver, RefusesMoreThanTheMemoryAllows) {
  const ConstraintSet set = constraint_set(star_stack(3, 2));
  for (const SolverChoice choice : {SolverChoice::dense, SolverChoice::fast}) {
    InterpolationOptions options;
    options.solver = choice;
    options.memory_limit_bytes = 5'000'000;
    try {
      const InterpolationSolver solver(set, options);
      FAIL() << "nothing solves " << set.values.size() << " constraints in 5 MB";
    } catch (const SolveError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(std::to_string(set.values.size()) + " constraints"), std::string::npos) << message;
      EXPECT_NE(message.find("--memory"), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace isostack

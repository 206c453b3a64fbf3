// The fast solver where constraints are few, degenerate, far away, in another unit, too close or contradictory, and
// where it must stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "recon/geometry/errors.h"
#include "recon/solvers/dense_solver.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/fast_solver.h"
#include "tests/support/solver_cases.h"

namespace isostack {
namespace {

using benchmarks::star_stack;
using benchmarks::StarStack;

class FastSolverRobustness : public testing::TestWithParam<std::string> {
 protected:
  Kernel kernel = kernel_named(GetParam());
};

TEST_P(FastSolverRobustness, FewPoints) {
  for (const int count : {4, 5, 10, 63, 65, 200}) {
    const Eigen::MatrixXd points = random_points(3, count, static_cast<unsigned>(count)), at = random_points(3, 50, 1);
    const Eigen::VectorXd values = points.row(0).array().square() / 1000;
    const Solution solution = FastSolver(kernel, points, {}, to(1e-8)).solve(values);
    EXPECT_TRUE(solution.converged) << count << " " << solution.largest_residual;
    EXPECT_LT((evaluate(kernel, points, solution.function, points) - values).cwiseAbs().maxCoeff(), 1e-7) << count;
    if (count == 4) continue;  // as many as the tail has coefficients: nothing is left for the dense solver
    const RadialWeights dense = DenseSolver(kernel, points, {}, {}).solve(values);
    EXPECT_LT(
        (evaluate(kernel, points, solution.function, at) - evaluate(kernel, points, dense, at)).cwiseAbs().maxCoeff(),
        1e-6)
        << count;
  }
}

// The tail's polynomials are dependent on such points. f is unique on their span, and finite beyond it.
TEST_P(FastSolverRobustness, PointsInAnObliquePlaneOrOnALine) {
  const Eigen::MatrixXd u = random_points(2, 1500, 5), v = random_points(2, 200, 6);
  const Eigen::Vector3d origin(7, -3, 12), a(1, 0, 0.3), b(0, 1, -0.8);
  for (const bool line : {false, true}) {
    const auto lift = [&](const Eigen::MatrixXd& flat) -> Eigen::MatrixXd {
      Eigen::MatrixXd lifted = a * flat.row(0);
      if (!line) lifted += b * flat.row(1);
      return lifted.colwise() + origin;
    };
    const Eigen::MatrixXd points = lift(u), at = lift(v);
    const Eigen::VectorXd values = (u.row(0).array() / 30).cos();
    const Solution fast = FastSolver(kernel, points, {}, to(1e-6)).solve(values);
    EXPECT_TRUE(fast.converged) << "line: " << line << " residual " << fast.largest_residual << " " << fast.remark;
    const RadialWeights dense = DenseSolver(kernel, points, {}, {}).solve(values);
    const Eigen::VectorXd difference =
        evaluate(kernel, points, fast.function, at) - evaluate(kernel, points, dense, at);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-5) << "line: " << line;
    EXPECT_TRUE(evaluate(kernel, points, fast.function, random_points(3, 20, 8)).allFinite());
  }
}

TEST_P(FastSolverRobustness, FarFromTheOriginAndInOtherUnitsTheFunctionIsTheSame) {
  const StarStack c = star_stack(4, 2);
  const Eigen::MatrixXd at = c.points.leftCols(500).array() + 3;
  const Solution solution = FastSolver(kernel, c.points, {}, to(1e-6)).solve(c.values);
  const Eigen::VectorXd reference = evaluate(kernel, c.points, solution.function, at);
  struct Move {
    double unit, shift_mm;
  };
  for (const auto [unit, shift] : {Move{1e-3, 0}, Move{1e3, 0}, Move{1, 1e6}, Move{1e-3, 1e6}}) {
    const auto move = [unit = unit, shift = shift](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
      return (x.array() + shift) * unit;
    };
    const Solution moved = FastSolver(kernel, move(c.points), {}, to(1e-6)).solve(c.values);
    EXPECT_TRUE(moved.converged) << unit << " " << shift << " " << moved.largest_residual;
    const Eigen::VectorXd values = evaluate(kernel, move(c.points), moved.function, move(at));
    EXPECT_LT((values - reference).cwiseAbs().maxCoeff(), 1e-5) << "unit " << unit << " shift " << shift;
  }
}

// A tenth of a micrometre apart, as after merging. The values agree.
TEST_P(FastSolverRobustness, NearbyPointsThatAgreeAreSolved) {
  const StarStack c = star_stack(3, 2);
  Eigen::MatrixXd points(3, c.points.cols() + 20);
  points << c.points, c.points.leftCols(20).array() + 1e-4;
  Eigen::VectorXd values(points.cols());
  values << c.values, c.values.head(20);
  const Solution solution = FastSolver(kernel, points, {}, to(1e-5)).solve(values);
  EXPECT_TRUE(solution.converged) << solution.largest_residual << " " << solution.remark;
  EXPECT_LT((evaluate(kernel, points, solution.function, points) - values).cwiseAbs().maxCoeff(), 1e-4);
}

// Nearer than numbers can tell: the solver may fail, and then says so.
TEST_P(FastSolverRobustness, PointsANanometreFractionApartNeverGiveASilentlyWrongSolution) {
  const StarStack c = star_stack(3, 4);
  Eigen::MatrixXd points(3, c.points.cols() + 5);
  points << c.points, c.points.leftCols(5).array() + 1e-9;
  Eigen::VectorXd values(points.cols());
  values << c.values, c.values.head(5);
  const Solution solution = FastSolver(kernel, points, {}, to(1e-4)).solve(values);
  EXPECT_TRUE(solution.function.weights.allFinite());
  const double misfit = (evaluate(kernel, points, solution.function, points) - values).cwiseAbs().maxCoeff();
  EXPECT_EQ(solution.converged, solution.remark.empty());
  if (solution.converged) {
    EXPECT_LT(misfit, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FastSolverRobustness, testing::Values("biharmonic", "thin_plate", "triharmonic"),
                         [](const auto& one) { return one.param; });

// r³ climbs by 1 within a tenth of a micrometre only with weights whose rounding is felt everywhere: the solve stalls.
TEST(FastSolver, AStalledSolveSaysWhereAndWhy) {
  const StarStack c = star_stack(3, 2);
  Eigen::MatrixXd points(3, c.points.cols() + 1);
  points << c.points, c.points.col(400).array() + 1e-4;
  Eigen::VectorXd values(points.cols());
  values << c.values, c.values[400] + 1;
  const Solution solution = FastSolver(triharmonic(), points, {}, to(1e-5)).solve(values);
  EXPECT_FALSE(solution.converged);
  EXPECT_GT(solution.largest_residual, 1e-5);
  EXPECT_TRUE(solution.function.weights.allFinite());
  const std::size_t at = solution.remark.find('(');
  ASSERT_NE(at, std::string::npos) << solution.remark;
  EXPECT_EQ(std::count(solution.remark.begin(), solution.remark.end(), ','), 2) << solution.remark;  // a place in 3D
  EXPECT_NE(solution.remark.find("contradict"), std::string::npos) << solution.remark;
}

TEST(FastSolver, RefusesWhatDoesNotFitBeforeItStarts) {
  FastSolverOptions options;
  options.memory_limit_bytes = 1'000'000;
  Progress progress;
  progress.on_report = [](std::string_view stage, double) { FAIL() << stage << " began"; };
  try {
    FastSolver(biharmonic(), random_points(3, 1000, 7), {}, options, progress);
    FAIL() << "1,000 constraints need more than 1 MB";
  } catch (const SolveError& error) {
    const std::string message = error.what();
    for (const char* part : {"1000 constraints", "0.00 GB are allowed", "--memory"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

/// Solves until `stage` has passed `fraction`, then asks to stop. What was reported after that is counted.
struct Stopped {
  bool reached = false, cancelled = false;
  int reports_after = 0;
};

Stopped stop_at(const StarStack& c, std::string_view stage, double fraction) {
  Stopped stopped;
  Progress progress;
  const auto caller = std::this_thread::get_id();
  progress.on_report = [&](std::string_view now, double done) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    if (stopped.reached) ++stopped.reports_after;
    if (now == stage && done >= fraction) stopped.reached = true;
  };
  progress.is_cancelled = [&] { return stopped.reached; };
  try {
    FastSolver(triharmonic(), c.points, {}, to(1e-8), progress).solve(c.values, {}, progress);
  } catch (const Cancelled&) {
    stopped.cancelled = true;
  }
  return stopped;
}

TEST(FastSolver, StopsInEveryStageAtOnceWhenAsked) {
  const StarStack c = star_stack(6, 1.5);
  for (const std::string stage : {"order", "precondition", "solve"})
    for (const double fraction : {0.0, 0.5}) {
      const Stopped stopped = stop_at(c, stage, fraction);
      EXPECT_TRUE(stopped.reached) << stage << " never reported " << fraction;
      EXPECT_TRUE(stopped.cancelled) << stage << " " << fraction;
      EXPECT_EQ(stopped.reports_after, 0) << stage << " went on";
    }
}

// A stage stops at its reports only: between two of them there must be little work.
TEST(FastSolver, ReportsOftenEnoughToBeStoppedQuickly) {
  const StarStack c = star_stack(6, 1);
  std::map<std::string, double, std::less<>> last, largest_step;
  Progress progress;
  progress.on_report = [&](std::string_view stage, double done) {
    const std::string name(stage);
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    largest_step[name] = std::max(largest_step[name], done - last[name]);
    last[name] = done;
  };
  FastSolver(biharmonic(), c.points, {}, to(1e-5), progress).solve(c.values, {}, progress);
  // The finest level is half the points for points on curves; the rest is spread over a dozen coarser ones.
  EXPECT_LE(largest_step["order"], 0.6);
  EXPECT_LE(largest_step["precondition"], 0.6);
  EXPECT_LE(largest_step["solve"], 0.6);
}

}  // namespace
}  // namespace isostack

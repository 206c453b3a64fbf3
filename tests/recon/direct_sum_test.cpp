#include "recon/solvers/direct_sum.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

struct Problem {
  Eigen::MatrixXd centres, targets;
  Eigen::VectorXd weights;
};

/// The first targets are centres: the kernel's zero must not give a NaN.
Problem random_problem(int dimension, int centres, int targets, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-40, 40), weight(-1, 1);
  Problem problem;
  problem.centres = Eigen::MatrixXd::NullaryExpr(dimension, centres, [&] { return uniform(random); });
  problem.targets = Eigen::MatrixXd::NullaryExpr(dimension, targets, [&] { return uniform(random); });
  problem.weights = Eigen::VectorXd::NullaryExpr(centres, [&] { return weight(random); });
  const int shared = std::min({3, centres, targets});
  problem.targets.leftCols(shared) = problem.centres.leftCols(shared);
  return problem;
}

std::vector<Kernel> kernels_for(int dimension) {
  std::vector<Kernel> kernels = {biharmonic(), thin_plate(), triharmonic()};
  for (int order = dimension / 2 + 1; order <= dimension / 2 + 3; ++order) kernels.push_back(duchon(dimension, order));
  return kernels;
}

/// Tolerance: rounding of one term times the sum of their sizes; at the centre itself r counts as 1e-100.
void expect_equals_plain_loop(const Kernel& kernel, const Problem& problem) {
  const Eigen::VectorXd values = direct_sum(kernel, problem.centres, problem.weights, problem.targets);
  const Eigen::MatrixXd gradients = direct_sum_gradient(kernel, problem.centres, problem.weights, problem.targets);
  ASSERT_EQ(values.size(), problem.targets.cols());
  ASSERT_EQ(gradients.rows(), problem.targets.rows());
  ASSERT_EQ(gradients.cols(), problem.targets.cols());
  for (Eigen::Index i = 0; i < problem.targets.cols(); ++i) {
    double sum = 0, size = 0, gradient_size = 0;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(problem.targets.rows());
    for (Eigen::Index j = 0; j < problem.centres.cols(); ++j) {
      const Eigen::VectorXd offset = problem.targets.col(i) - problem.centres.col(j);
      const double term = problem.weights[j] * kernel.value(offset.squaredNorm());
      const Eigen::VectorXd slope = problem.weights[j] * kernel.slope_over_distance(offset.squaredNorm()) * offset;
      sum += term, size += std::abs(term);
      gradient += slope, gradient_size += slope.norm();
    }
    ASSERT_NEAR(values[i], sum, 1e-13 * size + 1e-99) << kernel.name() << ", target " << i;
    ASSERT_LE((gradients.col(i) - gradient).norm(), 1e-13 * gradient_size) << kernel.name() << ", target " << i;
  }
}

TEST(DirectSum, EqualsAPlainLoopForEveryKernelAndDimension) {
  for (int dimension = 1; dimension <= 6; ++dimension)
    for (const Kernel& kernel : kernels_for(dimension))
      expect_equals_plain_loop(kernel, random_problem(dimension, 133, 57, static_cast<unsigned>(dimension)));
}

TEST(DirectSum, HandlesSizesThatFillNoSimdLane) {
  for (const int centres : {1, 2, 3, 5, 7, 8, 9, 15, 17})
    for (const int targets : {1, 16, 19}) {
      expect_equals_plain_loop(triharmonic(), random_problem(3, centres, targets, 9));
      expect_equals_plain_loop(thin_plate(), random_problem(2, centres, targets, 10));
    }
}

TEST(DirectSum, WithoutCentresOrTargetsIsZeroOrEmpty) {
  const Eigen::MatrixXd none(3, 0), some = Eigen::MatrixXd::Random(3, 4);
  EXPECT_TRUE((direct_sum(biharmonic(), none, Eigen::VectorXd(0), some).array() == 0).all());
  EXPECT_TRUE((direct_sum_gradient(biharmonic(), none, Eigen::VectorXd(0), some).array() == 0).all());
  EXPECT_EQ(direct_sum(biharmonic(), some, Eigen::VectorXd::Ones(4), none).size(), 0);
}

TEST(DirectSum, AtItsOwnCentreEveryKernelIsExactlyHarmless) {
  const Eigen::MatrixXd point = Eigen::Vector3d(3, -7, 11);
  for (const Kernel& kernel : kernels_for(3)) {
    EXPECT_NEAR(direct_sum(kernel, point, Eigen::VectorXd::Ones(1), point)[0], 0, 1e-99) << kernel.name();
    EXPECT_EQ(direct_sum_gradient(kernel, point, Eigen::VectorXd::Ones(1), point).norm(), 0) << kernel.name();
  }
}

// Against Kernel's own slope and curvature: s·I + c·d·dᵀ per term.
TEST(DirectSum, HessianEqualsAPlainLoop) {
  for (const Kernel& kernel : kernels_for(3)) {
    Problem problem = random_problem(3, 133, 57, 12);
    problem.targets.leftCols(3).array() += 0.5;  // a kernel may have no second derivative at a centre
    const RadialSums sums = direct_sums(kernel, problem.centres, problem.weights, problem.targets, Derivatives::second);
    for (Eigen::Index i = 0; i < problem.targets.cols(); ++i) {
      Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
      double size = 0;
      for (Eigen::Index j = 0; j < problem.centres.cols(); ++j) {
        const Eigen::Vector3d d = problem.targets.col(i) - problem.centres.col(j);
        const Eigen::Matrix3d term =
            problem.weights[j] * (kernel.slope_over_distance(d.squaredNorm()) * Eigen::Matrix3d::Identity() +
                                  kernel.curvature_factor(d.squaredNorm()) * d * d.transpose());
        hessian += term, size += term.norm();
      }
      const Eigen::VectorXd h = sums.hessians.col(i);
      Eigen::Matrix3d found;
      found << h[0], h[5], h[4], h[5], h[1], h[3], h[4], h[3], h[2];
      ASSERT_LE((found - hessian).norm(), 1e-12 * size) << kernel.name() << ", target " << i;
    }
  }
}

// Centres in a plane of one more dimension, as a section of a morph sees them.
TEST(DirectSum, AShiftIsADistanceInAFurtherDimension) {
  for (const Kernel& kernel : {biharmonic(), thin_plate(), triharmonic()})
    for (const int dimension : {2, 3, 4}) {  // 2 and 3: the near sums; 4: any number of axes
      const Problem problem = random_problem(dimension, 133, 57, 12);
      const auto lifted = [&](const Eigen::MatrixXd& points, double height) {
        Eigen::MatrixXd result(dimension + 1, points.cols());
        result << points, Eigen::RowVectorXd::Constant(points.cols(), height);
        return result;
      };
      const RadialSums shifted = direct_sums(RadialFunction{kernel, 0.49}, problem.centres, problem.weights,
                                             problem.targets, Derivatives::first);
      const RadialSums expected = direct_sums(kernel, lifted(problem.centres, 1.2), problem.weights,
                                              lifted(problem.targets, 0.5), Derivatives::first);
      const double scale = expected.values.cwiseAbs().maxCoeff() + expected.gradients.cwiseAbs().maxCoeff();
      EXPECT_LT((shifted.values - expected.values).cwiseAbs().maxCoeff(), 1e-12 * scale);
      EXPECT_LT((shifted.gradients - expected.gradients.topRows(dimension)).cwiseAbs().maxCoeff(), 1e-12 * scale);
    }
}

TEST(DirectSum, RefusesWhatItCannotSum) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(4, 5);
  EXPECT_THROW(direct_sums(biharmonic(), points, Eigen::VectorXd::Ones(5), points, Derivatives::second), InputError);
}

TEST(DirectSum, DoesNotDependOnTheNumberOfThreads) {
  const Problem problem = random_problem(3, 777, 1003, 11);
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    return std::pair(direct_sum(thin_plate(), problem.centres, problem.weights, problem.targets),
                     direct_sum_gradient(thin_plate(), problem.centres, problem.weights, problem.targets));
  };
  const auto one = with_threads(1), two = with_threads(2);
  EXPECT_TRUE(one.first == two.first);
  EXPECT_TRUE(one.second == two.second);
}

}  // namespace
}  // namespace isostack

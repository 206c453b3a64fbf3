#include "recon/morphing/warp.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// Some points of a cube of this side, the same every time.
Eigen::MatrixXd points_in_cube(int dimension, Eigen::Index count, double side) {
  Eigen::MatrixXd points(dimension, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (int axis = 0; axis < dimension; ++axis)
      points(axis, i) = side * std::fmod((static_cast<double>(i) + 1) * std::sqrt(2.0 + axis * (axis + 1)), 1);
  return points;
}

/// A gentle displacement of the points.
Eigen::MatrixXd bend(const Eigen::MatrixXd& points) {
  Eigen::MatrixXd result(points.rows(), points.cols());
  for (Eigen::Index axis = 0; axis < points.rows(); ++axis)
    result.row(axis) = 6 * (points.row((axis + 1) % points.rows()).array() / 25).sin();
  return result;
}

class InBothDimensions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Warp, InBothDimensions, testing::Values(2, 3));

TEST_P(InBothDimensions, TakesTheGivenDisplacements) {
  for (const Eigen::Index count : {1, 2, 3, 4, 5, 12}) {
    const Eigen::MatrixXd points = points_in_cube(GetParam(), count, 100);
    const Eigen::MatrixXd moved = Warp(points, bend(points)).displaced(points, 0.5);
    EXPECT_LT((moved - points - 0.5 * bend(points)).cwiseAbs().maxCoeff(), 1e-9) << count << " points";
  }
}

TEST_P(InBothDimensions, IsUndone) {
  const Eigen::MatrixXd landmarks = points_in_cube(GetParam(), 9, 100);
  const Warp warp(landmarks, bend(landmarks));
  const Eigen::MatrixXd points = points_in_cube(GetParam(), 200, 120);
  for (const double amount : {0.0, 0.3, 1.0})
    EXPECT_LT((warp.undisplaced(warp.displaced(points, amount), amount) - points).cwiseAbs().maxCoeff(), 1e-7);
}

TEST_P(InBothDimensions, JacobiansAreItsDerivatives) {
  const Eigen::MatrixXd landmarks = points_in_cube(GetParam(), 9, 100);
  const Warp warp(landmarks, bend(landmarks));
  const Eigen::MatrixXd points = points_in_cube(GetParam(), 20, 110);
  const auto jacobians = warp.jacobians(points, 0.8);
  const double step = 1e-4;
  for (int axis = 0; axis < GetParam(); ++axis) {
    const Eigen::VectorXd offset = step * Eigen::VectorXd::Unit(GetParam(), axis);
    const Eigen::MatrixXd slopes =
        (warp.displaced(points.colwise() + offset, 0.8) - warp.displaced(points.colwise() - offset, 0.8)) / (2 * step);
    for (Eigen::Index p = 0; p < points.cols(); ++p)
      EXPECT_LT((jacobians[static_cast<std::size_t>(p)].col(axis) - slopes.col(p)).norm(), 1e-6);
  }
}

TEST(Warp, OfOnePointIsATranslation) {
  const Warp warp(Eigen::Vector2d(3, 4), Eigen::Vector2d(5, -6));
  const Eigen::MatrixXd points = points_in_cube(2, 20, 100);
  EXPECT_LT((warp.displaced(points, 1) - (points.colwise() + Eigen::Vector2d(5, -6))).cwiseAbs().maxCoeff(), 1e-12);
}

/// Few or aligned points leave linear functions undetermined; what is chosen must not depend on the axes.
TEST(Warp, TurnsWithItsPoints) {
  const double angle = 0.6;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  Eigen::MatrixXd aligned(2, 4);
  aligned << 10, 20, 40, 80, 15, 30, 60, 120;
  const Eigen::MatrixXd points = points_in_cube(2, 30, 100);
  for (const Eigen::MatrixXd& landmarks : {Eigen::MatrixXd(points_in_cube(2, 2, 100)), aligned}) {
    const Eigen::MatrixXd displacements = bend(landmarks);
    const Eigen::MatrixXd turned = Warp(turn * landmarks, turn * displacements).displaced(turn * points, 1);
    EXPECT_LT((turned - turn * Warp(landmarks, displacements).displaced(points, 1)).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(Warp, ThatFoldsIsNotUndone) {
  Eigen::MatrixXd points(2, 4), displacements(2, 4);
  points << 0, 10, 0, 10, 0, 0, 10, 10;
  displacements << 30, -30, 30, -30, 0, 0, 0, 0;  // left and right change places
  const Warp warp(points, displacements);
  EXPECT_THROW(warp.undisplaced(points_in_cube(2, 20, 10), 1), GeometryError);
}

}  // namespace
}  // namespace isostack

#include "recon/constraints/merge.h"

#include <gtest/gtest.h>

#include <random>

namespace isostack {
namespace {

TEST(MergeCoinciding, DuplicatesBecomeOneWithTheMeanValue) {
  ConstraintSet set;
  set.points.resize(3, 5);
  set.points << 0, 1, 0, 2, 0,  //
      0, 1, 0, 2, 0,            //
      0, 1, 0, 2, 5e-4;
  set.values = (Eigen::VectorXd(5) << 0, 3, 1, 4, 2).finished();
  const MergedConstraints merged = merge_coinciding(set, 1e-3);
  ASSERT_EQ(merged.set.points.cols(), 3);
  EXPECT_EQ(merged.set.values, Eigen::Vector3d(1, 3, 4));
  EXPECT_EQ(merged.group_of, (std::vector<Eigen::Index>{0, 1, 0, 2, 0}));
  EXPECT_EQ(merged.largest_contradiction, 2);
}

TEST(MergeCoinciding, DistinctPointsKeepTheirOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  ConstraintSet set;
  set.points = Eigen::MatrixXd::NullaryExpr(4, 200, [&] { return uniform(random); });
  set.values = Eigen::VectorXd::LinSpaced(200, 0, 1);
  const MergedConstraints merged = merge_coinciding(set, 1e-9);
  EXPECT_EQ(merged.set.points, set.points);
  EXPECT_EQ(merged.set.values, set.values);
  EXPECT_EQ(merged.largest_contradiction, 0);
}

// A sagittal stack has all points of a slice at one x; comparing them all with each other would take minutes.
TEST(MergeCoinciding, PointsInOnePlaneOfAnyAxisAreMergedAsElsewhere) {
  constexpr Eigen::Index count = 200'000;
  for (int axis = 0; axis < 3; ++axis) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 500);
    ConstraintSet set;
    set.points = Eigen::MatrixXd::NullaryExpr(3, count, [&] { return uniform(random); });
    set.points.row(axis).setConstant(1e6);
    set.points.rightCols(100) = set.points.leftCols(100);
    set.values = Eigen::VectorXd::Zero(count);
    EXPECT_EQ(merge_coinciding(set, 0).set.points.cols(), count - 100) << axis;
  }
}

TEST(MergeCoinciding, LaterPointsDoNotDisplaceEarlierOnes) {
  ConstraintSet set;
  set.points.resize(3, 3);
  set.points << 1, 2, 1 - 1e-4,  //
      1, 2, 1,                   //
      1, 2, 1;
  set.values = Eigen::Vector3d(0, 5, 0);
  const MergedConstraints merged = merge_coinciding(set, 1e-3);
  EXPECT_EQ(merged.set.points, set.points.leftCols(2));
}

}  // namespace
}  // namespace isostack

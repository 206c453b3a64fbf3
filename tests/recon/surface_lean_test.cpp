#include "recon/constraints/surface_lean.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isostack {
namespace {

Eigen::Matrix3Xd same(const Eigen::Vector3d& v, Eigen::Index count) { return v.replicate(1, count); }

TEST(SmoothedLean, OneTiltIsItsCosine) {
  // A plane tilted by 30° from upright over slices z = const: normal (cos 30°, 0, sin 30°).
  Eigen::Matrix3Xd points(3, 50);
  for (int i = 0; i < 50; ++i) points.col(i) = Eigen::Vector3d(0, 0.5 * i, 0);
  const double tilt = M_PI / 6;
  const Eigen::VectorXd lean = smoothed_lean(same(7 * Eigen::Vector3d(std::cos(tilt), 0, std::sin(tilt)), 50), points,
                                             same(Eigen::Vector3d::UnitZ(), 50), 3);
  EXPECT_NEAR(lean.minCoeff(), 0.5, 1e-12);
  EXPECT_NEAR(lean.maxCoeff(), 0.5, 1e-12);
}

TEST(SmoothedLean, RipplesOfSingleNormalsAverageOut) {
  // An upright wall whose normals tilt up and down by turns, as the stairs of pixels make them.
  Eigen::Matrix3Xd points(3, 101), gradients(3, 101);
  for (int i = 0; i <= 100; ++i) {
    points.col(i) = Eigen::Vector3d(0, 0.5 * i, 0);
    gradients.col(i) = Eigen::Vector3d(1, 0, i % 2 == 0 ? 0.5 : -0.5);
  }
  const Eigen::VectorXd lean = smoothed_lean(gradients, points, same(Eigen::Vector3d::UnitZ(), 101), 4);
  // Single normals lean by ±0.447. Opposite ones weigh by their likeness, 0.6: (1 − 0.6) / (1 + 0.6) of it remains.
  EXPECT_LT(lean.segment(10, 80).cwiseAbs().maxCoeff(), 0.447 / 4);
}

TEST(SmoothedLean, SidesOfAThinSheetDoNotMix) {
  // Two sides 0.2 mm apart: the normals of one lean up, those of the other face the other way and lean down.
  Eigen::Matrix3Xd points(3, 80), gradients(3, 80);
  for (int i = 0; i < 40; ++i) {
    points.col(i) = Eigen::Vector3d(0, 0.5 * i, 0);
    points.col(40 + i) = Eigen::Vector3d(0.2, 0.5 * i, 0);
    gradients.col(i) = Eigen::Vector3d(-0.8, 0, 0.6);
    gradients.col(40 + i) = Eigen::Vector3d(0.8, 0, -0.6);
  }
  const Eigen::VectorXd lean = smoothed_lean(gradients, points, same(Eigen::Vector3d::UnitZ(), 80), 5);
  for (int i = 0; i < 80; ++i) EXPECT_NEAR(lean[i], i < 40 ? 0.6 : -0.6, 1e-12);
}

TEST(SmoothedLean, DoesNotReachBeyondItsRadius) {
  Eigen::Matrix3Xd points(3, 2), gradients(3, 2);
  points << 0, 3, 0, 0, 0, 0;
  gradients << 1, 0.6, 0, 0, 0, 0.8;
  const Eigen::VectorXd apart = smoothed_lean(gradients, points, same(Eigen::Vector3d::UnitZ(), 2), 2);
  EXPECT_NEAR(apart[0], 0, 1e-12);
  EXPECT_NEAR(apart[1], 0.8, 1e-12);
  EXPECT_GT(smoothed_lean(gradients, points, same(Eigen::Vector3d::UnitZ(), 2), 5)[0], 0.1);
}

}  // namespace
}  // namespace isostack

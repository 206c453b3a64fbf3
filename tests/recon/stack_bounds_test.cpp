#include "recon/surface/stack_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::field_of;

Eigen::Matrix3d turned() { return Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix(); }

std::vector<SlicePose> parallel(const std::vector<double>& heights_mm) {
  std::vector<SlicePose> poses;
  for (const double height : heights_mm)
    poses.push_back({.origin_mm = height * turned().col(2), .x_axis = turned().col(0), .y_axis = turned().col(1)});
  return poses;
}

std::vector<Eigen::Vector3d> ring(const std::vector<SlicePose>& poses, double radius_mm) {
  std::vector<Eigen::Vector3d> points;
  for (const SlicePose& pose : poses)
    for (const Eigen::Vector2d& p : testing_support::circle({0, 0}, radius_mm, 40).points_mm)
      points.push_back(pose.slice_to_world(p));
  return points;
}

std::function<Eigen::VectorXd(const Eigen::MatrixXd&)> values_of(std::function<double(const Eigen::Vector3d&)> f) {
  return [field = field_of(std::move(f))](const Eigen::MatrixXd& p) -> Eigen::VectorXd { return field.values(p); };
}

/// f by the height along the stack's normal.
std::function<Eigen::VectorXd(const Eigen::MatrixXd&)> by_height(std::function<double(double)> f) {
  return values_of([f](const Eigen::Vector3d& p) { return f(p.dot(turned().col(2))); });
}

/// The heights between which the bounds let the surface be.
std::pair<double, double> reach_of(const StackBounds& bounds) {
  double low = -1e3, high = 1e3;
  for (const auto& half_space : bounds.half_spaces) {
    const double along = half_space.normal().dot(turned().col(2));
    const double height = -half_space.offset() / along;
    (along > 0 ? low : high) = height;
  }
  return {low, high};
}

TEST(StackBounds, RoundEndsMayReachOneAndAHalfGaps) {
  const auto poses = parallel({0, 4, 8, 14});
  const auto bounds = stack_bounds(poses, ring(poses, 10), by_height([](double h) { return std::min(h + 1, 15 - h); }));
  EXPECT_FALSE(bounds.open_end);
  ASSERT_EQ(bounds.half_spaces.size(), 2u);
  EXPECT_NEAR(reach_of(bounds).first, -6, 1e-9);       // gap 4
  EXPECT_NEAR(reach_of(bounds).second, 14 + 9, 1e-9);  // gap 6
  for (const auto& half_space : bounds.half_spaces)
    EXPECT_GT(half_space.signedDistance(poses[1].origin_mm), 0) << "positive within";
}

TEST(StackBounds, AnOrganCutByTheEndStopsHalfAGapBeyond) {
  const auto poses = parallel({14, 8, 0, 4});  // in any order
  const auto bounds = stack_bounds(poses, ring(poses, 10), by_height([](double h) { return h + 1; }));
  EXPECT_TRUE(bounds.open_end);
  EXPECT_NEAR(reach_of(bounds).first, -6, 1e-9);
  EXPECT_NEAR(reach_of(bounds).second, 14 + 3, 1e-9);
}

TEST(StackBounds, GapIsToTheNextPlaneAlsoWhereTwoSlicesShareOne) {
  const auto poses = parallel({0, 0, 5, 10, 10});
  const auto bounds = stack_bounds(poses, ring(poses, 10), by_height([](double h) { return std::min(h + 1, 11 - h); }));
  EXPECT_FALSE(bounds.open_end);
  EXPECT_NEAR(reach_of(bounds).first, -7.5, 1e-9);
  EXPECT_NEAR(reach_of(bounds).second, 17.5, 1e-9);
}

TEST(StackBounds, BoxIsAQuarterDiagonalWider) {
  const auto poses = parallel({0, 4});
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {3, 4, 12}};  // diagonal 13
  const auto bounds = stack_bounds(poses, corners, by_height([](double) { return -1; }));
  EXPECT_TRUE(bounds.box.min().isApprox(Eigen::Vector3d::Constant(-3.25)));
  EXPECT_TRUE(bounds.box.max().isApprox(Eigen::Vector3d(6.25, 7.25, 15.25)));
}

TEST(StackBounds, CrossingPlanesOrASingleOneHaveNoEnds) {
  auto poses = parallel({0, 4});
  const auto always = by_height([](double) { return 1.0; });
  EXPECT_TRUE(stack_bounds({poses[0]}, ring(poses, 10), always).half_spaces.empty());
  poses.push_back({.origin_mm = {0, 0, 0}, .x_axis = turned().col(0), .y_axis = turned().col(2)});
  const StackBounds bounds = stack_bounds(poses, ring(poses, 10), always);
  EXPECT_TRUE(bounds.half_spaces.empty());
  EXPECT_FALSE(bounds.open_end);
}

}  // namespace
}  // namespace isostack

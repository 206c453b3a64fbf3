#include "recon/morphing/signed_distance_stack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

Contour circle(double radius_mm, const Eigen::Vector2d& centre_mm) {
  Contour contour;
  for (int i = 0; i < 360; ++i) {
    const double angle = 2 * std::numbers::pi * i / 360;
    contour.points_mm.push_back(centre_mm + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return contour;
}

ContourSlice circle_slice(double z_mm, double radius_mm) {
  ContourSlice slice;
  slice.name = "z " + std::to_string(z_mm);
  slice.pose.origin_mm.z() = z_mm;
  slice.size_pixels = {41, 31};
  if (radius_mm > 0) slice.contours.push_back(circle(radius_mm, {20, 15}));
  return slice;
}

constexpr double facet_mm = 0.001;  // a circle of 12 mm with 360 corners: 12 · (1 − cos 0.5°) = 0.0005

TEST(SignedDistanceImage, OfACircleIsTheDistanceToIt) {
  const ContourSlice slice = circle_slice(0, 9);
  const Image<float> image = signed_distance_image(slice.contours, slice.pose, {slice.pose, slice.size_pixels});
  ASSERT_EQ(image.rows(), 31);
  ASSERT_EQ(image.cols(), 41);
  for (const auto& [column, row] : {std::pair{20, 15}, std::pair{20, 20}, std::pair{0, 0}, std::pair{40, 15}})
    EXPECT_NEAR(image(row, column), 9 - std::hypot(column - 20, row - 15), facet_mm) << column << ", " << row;
}

TEST(SignedDistanceStack, LinearOfAConeIsTheCone) {
  const ContourStack cone{"cone", {circle_slice(10, 12), circle_slice(0, 4), circle_slice(4, 7.2)}};  // not in order
  const auto stack = signed_distance_stack(cone, {cone.slices[1].pose, {41, 31}});
  ASSERT_EQ(stack.positions_mm, (std::vector<double>{0, 4, 10}));
  for (const double z : {0.0, 1.0, 5.5, 10.0}) {
    const Image<float> image = interpolate(stack, z, AlongNormal::linear);
    EXPECT_NEAR(image(15, 30), 4 + 0.8 * z - 10, 2 * facet_mm) << z;
  }
}

TEST(SignedDistanceStack, EndsHalfWayToASliceWithoutTheOrgan) {
  const ContourStack contours{"end", {circle_slice(0, 5), circle_slice(10, 0)}};
  const auto stack = signed_distance_stack(contours, {contours.slices[0].pose, {41, 31}});
  EXPECT_NEAR(interpolate(stack, 10, AlongNormal::linear)(15, 20), -5, 1e-6);  // half the gap
  EXPECT_NEAR(interpolate(stack, 5, AlongNormal::linear)(15, 20), 0, facet_mm);
  EXPECT_NEAR(interpolate(stack, 10, AlongNormal::linear)(15, 37), -std::hypot(5, 12), facet_mm);
}

TEST(WeightsAlong, CubicTakesAStraightLineAsItIsAndPassesThroughTheSlices) {
  const std::vector<double> positions = {-3, 0, 1, 5, 9};
  for (const double at : {-3.0, -1.0, 0.25, 1.0, 4.0, 8.5}) {
    const Eigen::VectorXd weights = weights_along(positions, at, AlongNormal::cubic);
    double line = 0;
    for (Eigen::Index i = 0; i < 5; ++i) line += weights[i] * (2 * positions[static_cast<std::size_t>(i)] + 1);
    EXPECT_NEAR(line, 2 * at + 1, 1e-12);
    EXPECT_NEAR(weights.sum(), 1, 1e-12);
  }
  EXPECT_NEAR(weights_along(positions, 1, AlongNormal::cubic)[2], 1, 1e-12);
}

TEST(WeightsAlong, CubicIsTheNaturalSpline) {
  // Knots 0, 1, 2 with values 0, 1, 0: second derivatives 0, −3, 0, so s(1/2) = 1/2 + (1/8 − 1/2)/6 · (−3) = 11/16.
  EXPECT_NEAR(weights_along({0, 1, 2}, 0.5, AlongNormal::cubic)[1], 11.0 / 16, 1e-12);
}

TEST(WeightsAlong, HoldsTheEndsBeyondTheStack) {
  for (const auto how : {AlongNormal::linear, AlongNormal::cubic})
    EXPECT_NEAR(weights_along({0, 1, 3}, 8, how)[2], 1, 1e-12);
}

TEST(SignedDistanceStack, RefusesWhatIsNoStack) {
  ContourStack crossing{"crossing", {circle_slice(0, 5), circle_slice(4, 5)}};
  const PixelLattice lattice{crossing.slices[0].pose, {41, 31}};
  ContourStack twice = crossing, single = crossing;
  crossing.slices[1].pose.y_axis = Eigen::Vector3d::UnitZ();
  EXPECT_THROW(signed_distance_stack(crossing, lattice), GeometryError);
  twice.slices[1].pose.origin_mm.z() = 0;
  EXPECT_THROW(signed_distance_stack(twice, lattice), GeometryError);
  single.slices.pop_back();
  EXPECT_THROW(signed_distance_stack(single, lattice), GeometryError);
}

}  // namespace
}  // namespace isostack

#include "recon/geometry/contour.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;

Contour square(double low, double high) { return {.points_mm = {{low, low}, {high, low}, {high, high}, {low, high}}}; }

TEST(ContourMeasures, PolygonOnACircleHasItsClosedForm) {
  const int n = 90;
  const double radius = 12, angle = 2 * std::numbers::pi / n;
  const Contour outer = circle({100, -40}, radius, n), hole = circle({100, -40}, radius, n, true);
  const double area = n * radius * radius * std::sin(angle) / 2;
  EXPECT_NEAR(signed_area_mm2(outer), area, 1e-9);
  EXPECT_NEAR(signed_area_mm2(hole), -area, 1e-9);
  EXPECT_NEAR(perimeter_mm(outer), 2 * n * radius * std::sin(angle / 2), 1e-10);
}

TEST(IsInside, EvenOddOverRingAndIsland) {
  const std::vector<Contour> loops = {circle({0, 0}, 10, 200), circle({0, 0}, 6, 200, true), circle({0, 0}, 2, 200)};
  EXPECT_FALSE(is_inside(loops, {11, 0}));
  EXPECT_TRUE(is_inside(loops, {8, 0}));
  EXPECT_FALSE(is_inside(loops, {0, -4}));
  EXPECT_TRUE(is_inside(loops, {1, 1}));
}

TEST(IsInside, SharedEdgeBelongsToOneOfTwoNeighbours) {
  const std::vector<Contour> left = {square(0, 4)}, right = {{.points_mm = {{4, 0}, {8, 0}, {8, 4}, {4, 4}}}};
  for (const double y : {0.0, 1.0, 2.0, 3.0})
    EXPECT_EQ(is_inside(left, {4, y}) + is_inside(right, {4, y}), 1) << "y = " << y;
}

TEST(SignedDistance, OfASquareIsExact) {
  const std::vector<Contour> loops = {square(-5, 5)};
  EXPECT_DOUBLE_EQ(signed_distance_mm(loops, {0, 0}), 5);
  EXPECT_DOUBLE_EQ(signed_distance_mm(loops, {3, 1}), 2);
  EXPECT_DOUBLE_EQ(signed_distance_mm(loops, {8, 9}), -5);  // 3-4-5 from the corner
  EXPECT_DOUBLE_EQ(std::abs(signed_distance_mm(loops, {5, 2})), 0);
}

TEST(SignedDistance, OfARingIsToTheNearerCurve) {
  const std::vector<Contour> loops = {circle({0, 0}, 10, 720), circle({0, 0}, 6, 720, true)};
  const double sagitta = 10 * (1 - std::cos(std::numbers::pi / 720));  // polygon against circle
  EXPECT_NEAR(signed_distance_mm(loops, {7, 0}), 1, sagitta);
  EXPECT_NEAR(signed_distance_mm(loops, {0, 9.5}), 0.5, sagitta);
  EXPECT_NEAR(signed_distance_mm(loops, {0, 0}), -6, sagitta);
}

TEST(SignedDistance, WithoutContoursIsMinusInfinity) {
  EXPECT_TRUE(std::isinf(signed_distance_mm({}, {0, 0})));
  EXPECT_LT(signed_distance_mm({}, {0, 0}), 0);
}

/// Every vertex of each once as its first, and both orders: what a curve begins with means nothing.
void expect_nesting(Contour a, Contour b, int depth_of_a, int depth_of_b) {
  for (std::size_t i = 0; i < a.points_mm.size(); ++i) {
    std::rotate(a.points_mm.begin(), a.points_mm.begin() + 1, a.points_mm.end());
    for (std::size_t j = 0; j < b.points_mm.size(); ++j) {
      std::rotate(b.points_mm.begin(), b.points_mm.begin() + 1, b.points_mm.end());
      std::vector<Contour> loops = {a, b}, reversed = {b, a};
      orient_by_nesting(loops);
      orient_by_nesting(reversed);
      EXPECT_EQ(loops[0].depth, depth_of_a) << i << " " << j;
      EXPECT_EQ(loops[1].depth, depth_of_b) << i << " " << j;
      EXPECT_EQ(reversed[0].depth, depth_of_b) << i << " " << j;
      EXPECT_EQ(reversed[1].depth, depth_of_a) << i << " " << j;
    }
  }
}

TEST(OrientByNesting, CurvesMayTouch) {
  for (const double angle : {0.0, 0.3, 1.1, 2.9}) {  // of the whole figure: rounding differs
    const Eigen::Rotation2Dd turn(angle);
    const auto curve = [&](std::vector<Eigen::Vector2d> points) {
      for (Eigen::Vector2d& point : points) point = turn * point + Eigen::Vector2d(-31.7, 12.9);
      return Contour{.points_mm = points};
    };
    const Contour square = curve({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    expect_nesting(square, curve({{0, 0}, {4, 1}, {1, 4}}), 0, 1);                // a hole in its corner
    expect_nesting(square, curve({{10, 3}, {4, 3}, {4, 7}}), 0, 1);               // a vertex on its edge
    expect_nesting(square, curve({{5, 0}, {10, 5}, {5, 10}, {0, 5}}), 0, 1);      // every vertex on its edges
    expect_nesting(square, curve({{0, 2}, {5, 2}, {5, 8}, {0, 8}}), 0, 1);        // along its edge
    expect_nesting(square, curve({{0, 0}, {10, 0}, {10, 10}}), 0, 1);             // edge midpoints tell
    expect_nesting(square, curve({{10, 10}, {14, 11}, {11, 14}}), 0, 0);          // tip to tip
    expect_nesting(square, curve({{10, 0}, {20, 0}, {20, 10}, {10, 10}}), 0, 0);  // side by side
  }
}

TEST(OrientByNesting, GivesDepthAndDirectionWhateverTheOrder) {
  std::vector<Contour> loops = {circle({0, 0}, 2, 40, true), circle({0, 0}, 10, 40, true), circle({0, 0}, 6, 40),
                                circle({30, 0}, 3, 40)};
  orient_by_nesting(loops);
  const int depths[] = {2, 0, 1, 0};
  for (std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_EQ(loops[i].depth, depths[i]) << i;
    EXPECT_EQ(signed_area_mm2(loops[i]) > 0, depths[i] % 2 == 0) << i;
  }
}

TEST(PointCount, SumsOverSlicesAndContours) {
  ContourStack stack;
  stack.slices.resize(3);
  stack.slices[0].contours = {circle({0, 0}, 1, 10), circle({5, 0}, 1, 7)};
  stack.slices[2].contours = {circle({0, 0}, 1, 4)};
  EXPECT_EQ(point_count(stack), 21u);
}

}  // namespace
}  // namespace isostack

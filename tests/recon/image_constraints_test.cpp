#include "recon/constraints/image_constraints.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isostack {
namespace {

Image<float> ramp(int rows, int columns, double per_column, double per_row) {
  Image<float> image(rows, columns);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      image(row, column) = static_cast<float>(per_column * column + per_row * row);
  return image;
}

TEST(ImageConstraints, OfAnObliqueRampAreExactUpToTheBorder) {
  const Image<float> image = ramp(12, 9, 4, 2);  // exact in float
  const Eigen::Vector2d slope(4, 2);
  const double level = 21;
  const auto constraints = image_constraints(image, level);
  for (const ImageConstraint& c : constraints) {
    EXPECT_NEAR(slope.dot(c.boundary_pixel), level, 1e-9);
    const Eigen::Vector2d normal = c.normal_pixel - c.boundary_pixel;
    EXPECT_LT((normal - slope.normalized()).norm(), 1e-9) << "at " << c.boundary_pixel.transpose();
  }
  std::size_t crossings = 0;  // of the line 4x + 2y = 21 with the lattice's lines: x at whole y, y at whole x
  for (int row = 0; row < 12; ++row) crossings += (21 - 2 * row) / 4.0 >= 0 && (21 - 2 * row) / 4.0 <= 8 ? 1 : 0;
  for (int column = 0; column < 9; ++column) crossings += (21 - 4 * column) / 2.0 >= 0 && (21 - 4 * column) / 2.0 <= 11;
  EXPECT_EQ(constraints.size(), crossings);
}

TEST(ImageConstraints, NormalsPointToTheBrighterSide) {
  for (const double sign : {1.0, -1.0}) {
    const auto constraints = image_constraints(ramp(5, 8, sign * 10, 0), sign * 34);
    ASSERT_EQ(constraints.size(), 5u);
    for (const ImageConstraint& c : constraints) {
      EXPECT_NEAR(c.boundary_pixel.x(), 3.4, 1e-6);
      EXPECT_NEAR(c.normal_pixel.x(), 3.4 + sign, 1e-6);
    }
  }
}

TEST(ImageConstraints, TheLevelItselfIsInside) {
  const auto constraints = image_constraints(ramp(3, 6, 10, 0), 30);  // column 3 is at the level
  ASSERT_EQ(constraints.size(), 3u);                                  // one per row, not one on either side
  for (const ImageConstraint& c : constraints) EXPECT_DOUBLE_EQ(c.boundary_pixel.x(), 3);
}

TEST(ImageConstraints, OfAUniformImageAreNone) { EXPECT_TRUE(image_constraints(ramp(4, 4, 0, 0), 0).empty()); }

SliceStack two_slices() {
  SliceStack stack;
  for (const double z_mm : {0.0, 7.0}) {
    Slice slice{.name = "s", .pose = {}, .pixels = ramp(10, 12, 10, 0)};
    slice.pose.origin_mm = {100, 200, z_mm};
    slice.pose.spacing_mm = {0.5, 2};
    stack.slices.push_back(slice);
  }
  return stack;
}

TEST(ImageConstraintSet, LiesInWorldBoundaryFirst) {
  const ConstraintSet set = image_constraint_set(two_slices(), 44, 1000);
  ASSERT_EQ(set.values.size(), 40);  // two slices of ten rows, two each
  EXPECT_TRUE((set.values.head(20).array() == 0).all());
  EXPECT_TRUE((set.values.tail(20).array() == 1).all());
  for (Eigen::Index i = 0; i < 20; ++i) {
    EXPECT_NEAR(set.points(0, i), 100 + 0.5 * 4.4, 1e-6);
    EXPECT_NEAR(set.points(1, i), 200 + 2.0 * static_cast<double>(i % 10), 1e-9);
    EXPECT_NEAR((set.points.col(20 + i) - set.points.col(i)).norm(), 0.5, 1e-9);  // one pixel along x
    EXPECT_DOUBLE_EQ(set.points(2, i), i < 10 ? 0 : 7);
  }
}

TEST(ImageConstraintSet, KeepsToTheLimit) {
  for (const std::size_t limit : {2u, 3u, 7u, 13u, 21u, 39u, 40u}) {
    const ConstraintSet set = image_constraint_set(two_slices(), 44, limit);
    EXPECT_LE(set.values.size(), static_cast<Eigen::Index>(limit));
    EXPECT_GE(2 * set.values.size() + 1, static_cast<Eigen::Index>(limit)) << "at least half the room is used";
    EXPECT_EQ(set.points.cols(), set.values.size());
  }
}

}  // namespace
}  // namespace isostack

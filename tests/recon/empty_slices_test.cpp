#include "recon/constraints/empty_slices.h"

#include <gtest/gtest.h>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;

ContourSlice axial(double z_mm, std::vector<Contour> contours = {}) {
  ContourSlice slice{.name = "z = " + std::to_string(z_mm), .pose = {}, .contours = std::move(contours)};
  slice.pose.origin_mm = {-50, -50, z_mm};
  return slice;
}

Contour disc() { return circle({50, 50}, 20, 100); }  // about the world's z axis

TEST(HalfGap, IsToTheNearestSliceWithContours) {
  const ContourStack stack{.name = "", .slices = {axial(0, {disc()}), axial(4), axial(7), axial(9)}};
  EXPECT_DOUBLE_EQ(half_gap_to_contours_mm(stack, stack.slices[1]), 2);
  EXPECT_DOUBLE_EQ(half_gap_to_contours_mm(stack, stack.slices[3]), 4.5);
}

TEST(HalfGap, WithoutOneIsFourPixels) {
  ContourStack stack{.name = "", .slices = {axial(0)}};
  stack.slices[0].pose.spacing_mm = {0.5, 0.7};
  EXPECT_DOUBLE_EQ(half_gap_to_contours_mm(stack, stack.slices[0]), 2);
}

}  // namespace
}  // namespace isostack

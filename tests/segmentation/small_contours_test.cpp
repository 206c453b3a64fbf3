#include "segmentation/small_contours.h"

#include <gtest/gtest.h>

#include "segmentation/segment.h"
#include "segmentation/trace_contours.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

/// Wherever its centre is, a disc of 1.5 pixels across reaches a pixel centre: those are 0.71 pixels away at most.
TEST(SmallContours, DiscOfOneAndAHalfPixelsIsNeverLost) {
  const Eigen::Vector2d spacing_mm(2, 2);
  for (double dx = 0; dx < 1; dx += 0.1)
    for (double dy = 0; dy < 1; dy += 0.1) {
      const Eigen::Vector2d centre_mm(2 * (5 + dx), 2 * (4 + dy));
      const auto phi = test::sampled(
          10, 12, spacing_mm, [&](double x, double y) { return 1.5 - (Eigen::Vector2d(x, y) - centre_mm).norm(); });
      const std::vector<Contour> contours = trace_contours(phi, spacing_mm);
      ASSERT_EQ(contours.size(), 1u) << dx << " " << dy;
      EXPECT_TRUE(is_inside(contours, centre_mm)) << dx << " " << dy;
    }
}

TEST(SmallContours, SinglePixelsAreCountedLargerOnesAreNot) {
  SliceStack stack;
  for (const char* name : {"a", "b"}) {
    Image<float> labels = Image<float>::Zero(9, 9);
    labels.block(5, 5, 3, 3) = 1;
    labels.row(0).segment(0, 2) = 1;
    stack.slices.push_back({name, {}, labels});
  }
  EXPECT_EQ(find_one_pixel_contours(trace_label(stack, 1)).count, 0u);
  EXPECT_EQ(remark_on_one_pixel_contours(trace_label(stack, 1)), "");
  stack.slices[1].pixels(2, 3) = 1;
  stack.slices[1].pixels(8, 0) = 1;  // at the border
  const OnePixelContours found = find_one_pixel_contours(trace_label(stack, 1));
  EXPECT_EQ(found.count, 2u);
  EXPECT_EQ(found.first_slice, "b");
}

}  // namespace
}  // namespace isostack

#include "recon/constraints/thin_between.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/reconstruct.h"
#include "recon/surface/plane_section.h"

namespace isostack {
namespace {

Contour rectangle(double left, double bottom, double width, double height) {
  Contour contour;  // points every 0.5 mm: pixels are 1 mm
  const auto side = [&](Eigen::Vector2d from, const Eigen::Vector2d& to) {
    const int steps = static_cast<int>(std::lround(2 * (to - from).norm()));
    for (int i = 0; i < steps; ++i) contour.points_mm.emplace_back(from + (to - from) * i / steps);
  };
  const Eigen::Vector2d a(left, bottom), b(left + width, bottom), c(left + width, bottom + height),
      d(left, bottom + height);
  side(a, b);
  side(b, c);
  side(c, d);
  side(d, a);
  return contour;
}

/// Slices `gap_mm` apart along z, one set of contours each, of 1 mm pixels.
ContourStack stacked(const std::vector<std::vector<Contour>>& contours, double gap_mm) {
  ContourStack stack;
  stack.name = "strips";
  for (const std::vector<Contour>& on_slice : contours) {
    ContourSlice slice;
    slice.name = "slice " + std::to_string(stack.slices.size());
    slice.pose.origin_mm.z() = gap_mm * static_cast<double>(stack.slices.size());
    slice.size_pixels = {100, 100};
    slice.contours = on_slice;
    stack.slices.push_back(slice);
  }
  return stack;
}

TEST(ThinBetween, FollowsAStripThatMovesByLessThanItsThickness) {
  const auto places = thin_between(stacked({{rectangle(20, 40, 60, 2.5)}, {rectangle(20, 41.2, 60, 2.5)}}, 12));
  std::vector<double> at_x[2];
  int beside = 0;
  for (const ThinPlace& place : places) {
    EXPECT_EQ(place.slice, 0u);
    if (place.distance_mm < 0) {  // beside it, where neither shows it
      EXPECT_TRUE(place.point_mm.y() < 40 || place.point_mm.y() > 43.7 || std::abs(place.point_mm.x() - 50) > 30)
          << place.point_mm.transpose();
      ++beside;
      continue;
    }
    EXPECT_GT(place.point_mm.y(), 41.2);  // where both show it
    EXPECT_LT(place.point_mm.y(), 42.5);
    EXPECT_LE(place.distance_mm, 1.25);  // half its thickness
    ASSERT_TRUE(std::abs(place.point_mm.z() - 4) < 1e-9 || std::abs(place.point_mm.z() - 8) < 1e-9);
    at_x[place.point_mm.z() > 6].push_back(place.point_mm.x());
  }
  EXPECT_GT(beside, 80);                 // on both sides, at both heights
  for (std::vector<double>& x : at_x) {  // all along it, every other pixel
    ASSERT_GT(x.size(), 20u);
    std::sort(x.begin(), x.end());
    EXPECT_LT(x.front(), 24);
    EXPECT_GT(x.back(), 76);
    for (std::size_t i = 1; i < x.size(); ++i) EXPECT_LE(x[i] - x[i - 1], 3.0);
  }
}

TEST(ThinBetween, SaysNothingWhereSlicesDoNotOverlapOrAreNear) {
  EXPECT_TRUE(thin_between(stacked({{rectangle(20, 40, 60, 2)}, {rectangle(20, 45, 60, 2)}}, 12)).empty());
  EXPECT_TRUE(thin_between(stacked({{rectangle(20, 40, 60, 2)}, {rectangle(20, 40, 60, 2)}}, 2)).empty());
  EXPECT_TRUE(thin_between(stacked({{rectangle(20, 40, 60, 2)}, {}}, 12)).empty());
}

/// A sheet 1.25 mm thick through slices 12 mm apart, the case in which samples on the slices alone leave islands.
TEST(ThinBetween, ASlantedSheetLastsFromSliceToSlice) {
  std::vector<std::vector<Contour>> contours;
  for (int i = 0; i < 3; ++i) contours.push_back({rectangle(20, 40 + 0.6 * i, 30, 1.25)});
  const Reconstruction result = reconstruct(stacked(contours, 12), {});
  for (const double z_mm : {4.0, 6.0, 8.0, 16.0, 18.0, 20.0}) {
    SlicePose between;
    between.origin_mm.z() = z_mm;
    double area_mm2 = 0;
    for (const Contour& contour : plane_section(result.surface, between)) area_mm2 += signed_area_mm2(contour);
    EXPECT_GT(area_mm2, 18) << z_mm;  // half of its 30 × 1.25: the kernel rounds off the narrow ends
    EXPECT_LT(area_mm2, 75) << z_mm;  // at most twice as thick
  }
}

}  // namespace
}  // namespace isostack

#include "segmentation/label_sections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// A ball of radius 10 mm about (20, 20, 20) in a grid of 0.5 x 0.5 x 1 mm.
LabelMap ball() {
  LabelVolume volume;
  volume.grid.size = {80, 80, 40};
  volume.grid.index_to_world = Eigen::Scaling(0.5, 0.5, 1.0) * Eigen::Affine3d::Identity();
  volume.voxels.assign(volume.grid.voxel_count(), 0);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 80; ++j)
      for (int i = 0; i < 80; ++i)
        if ((volume.grid.index_to_world * Eigen::Vector3d(i, j, k) - Eigen::Vector3d(20, 20, 20)).norm() < 10)
          volume.voxels[volume.grid.offset(i, j, k)] = 7;
  return {.layers = {volume}, .segments = {{.name = "ball", .value = 7, .layer = 0, .color = Color{9, 8, 7}}}};
}

ContourSlice plane_at(double height_mm, const Eigen::Vector3d& x_axis, const Eigen::Vector3d& y_axis) {
  ContourSlice plane;
  plane.name = "plane";
  plane.pose.x_axis = x_axis;
  plane.pose.y_axis = y_axis;
  plane.pose.spacing_mm = {0.8, 0.6};
  plane.pose.origin_mm = Eigen::Vector3d(20, 20, 20) + plane.pose.normal() * height_mm - 16 * x_axis - 15 * y_axis;
  plane.size_pixels = {40, 50};
  return plane;
}

TEST(LabelSections, ABallBecomesCirclesOnPlanesAlongAndAcrossTheGrid) {
  const LabelMap labels = ball();
  const Eigen::Vector3d diagonal = Eigen::Vector3d(0, 1, 1).normalized();
  const std::vector<ContourSlice> planes = {plane_at(0.4, {1, 0, 0}, {0, 1, 0}), plane_at(6.4, {1, 0, 0}, {0, 1, 0}),
                                            plane_at(12, {1, 0, 0}, {0, 1, 0}), plane_at(0, {1, 0, 0}, diagonal)};
  const std::vector<ContourStack> organs = label_sections(labels, labels.segments, planes);
  ASSERT_EQ(organs.size(), 1u);
  EXPECT_EQ(organs[0].name, "ball");
  EXPECT_EQ(organs[0].color, (Color{9, 8, 7}));
  ASSERT_EQ(organs[0].slices.size(), 4u);
  EXPECT_TRUE(organs[0].slices[2].contours.empty());
  // Planes take the voxels they lie in, half a voxel (0.5 mm) off at most; and pixels are 0.8 x 0.6 mm:
  // the border is a quarter of a pixel off at most on average.
  const double heights_mm[] = {0, 6, 0, 0};
  for (const std::size_t i : {0, 1, 3}) {
    ASSERT_EQ(organs[0].slices[i].contours.size(), 1u) << i;
    const double radius_mm = std::sqrt(100 - heights_mm[i] * heights_mm[i]);
    EXPECT_NEAR(signed_area_mm2(organs[0].slices[i].contours[0]), std::numbers::pi * radius_mm * radius_mm,
                0.2 * 2 * std::numbers::pi * radius_mm)
        << i;
  }
}

TEST(LabelSections, PlanesOfUnknownSizeAndSegmentsThatAreNotThere) {
  LabelMap labels = ball();
  ContourSlice plane = plane_at(0, {1, 0, 0}, {0, 1, 0});
  plane.size_pixels = {0, 0};
  EXPECT_THROW(label_sections(labels, labels.segments, {plane}), GeometryError);
  labels.segments[0].value = 3;
  EXPECT_THROW(label_sections(labels, labels.segments, {plane_at(0, {1, 0, 0}, {0, 1, 0})}), InputError);
}

}  // namespace
}  // namespace isostack

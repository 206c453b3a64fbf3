#include "viewers/view_planes.h"

#include <gtest/gtest.h>

#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

Slice image_at(double z_mm, const std::string& name) {
  Slice slice{.name = name, .pose = {}, .pixels = Image<float>::Zero(20, 30)};
  slice.pose.origin_mm = {-15, -10, z_mm};
  return slice;
}

/// A plane across the others.
Slice sagittal_image() {
  Slice slice = image_at(0, "sagittal");
  slice.pose.x_axis = Eigen::Vector3d::UnitY();
  slice.pose.y_axis = Eigen::Vector3d::UnitZ();
  return slice;
}

TEST(ViewPlanes, ParallelImagesComeInOrderAlongTheirNormal) {
  Scene scene;
  scene.slices = scene_slices({image_at(8, "c"), sagittal_image(), image_at(0, "a"), image_at(4, "b")});
  const std::vector<ViewPlane> planes = view_planes(scene);
  ASSERT_EQ(planes.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(planes[i].name, std::string(1, "abc"[i]));
  EXPECT_EQ(planes[3].name, "sagittal");
  EXPECT_EQ(planes[0].family, planes[2].family);
  EXPECT_NE(planes[0].family, planes[3].family);
  EXPECT_EQ(planes[0].image, 2U);
  // Pixels reach half a pixel beyond their centres: 30 columns and 20 rows of 1 mm.
  EXPECT_TRUE(planes[0].extent_mm.sizes().isApprox(Eigen::Vector2d(30, 20)));
  EXPECT_TRUE(planes[0].extent_mm.min().isApprox(Eigen::Vector2d(-0.5, -0.5)));
}

TEST(ViewPlanes, ContoursLieOnTheImageTheyWereDrawnOn) {
  Scene scene;
  scene.slices = scene_slices({image_at(0, "a"), image_at(4, "b")});
  SlicePose moved;  // another origin in the same planes
  moved.origin_mm = {3, 2, 0.05};
  scene.contours = scene_contours({testing_support::sphere_cuts(9, moved, {4, 0, 2}, 40)});
  const std::vector<ViewPlane> planes = view_planes(scene);
  ASSERT_EQ(planes.size(), 3U) << "two images, and a contour between them";
  ASSERT_EQ(planes[0].contours.size(), 1U);
  EXPECT_EQ(planes[0].contours[0].slice, 1U);
  EXPECT_FALSE(planes[1].image.has_value());
  EXPECT_EQ(planes[2].contours[0].slice, 0U);
  EXPECT_TRUE(planes[1].extent_mm.contains(Eigen::Vector2d(-3 + 8.7, -2))) << "what is around the contour";
}

TEST(ViewPlanes, ContoursOfAKnownImageHaveItsExtent) {
  ContourStack ball = testing_support::sphere_cuts(9, {}, {0}, 40);
  ball.slices[0].size_pixels = {30, 20};
  Scene scene;
  scene.contours = scene_contours({ball});
  EXPECT_TRUE(view_planes(scene)[0].extent_mm.sizes().isApprox(Eigen::Vector2d(30, 20)));
}

TEST(ViewPlanes, ASurfaceAloneIsCutAxially) {
  Scene scene;
  scene.surfaces = scene_surfaces({testing_support::box_mesh({-1, -2, 10}, {1, 2, 74})});
  const std::vector<ViewPlane> planes = view_planes(scene);
  ASSERT_EQ(planes.size(), 65U);
  EXPECT_NEAR(planes[0].pose.origin_mm.z(), 10, 1e-12);
  EXPECT_NEAR(planes[1].pose.origin_mm.z(), 11, 1e-12);
  EXPECT_TRUE(view_planes({}).empty());
}

TEST(ViewPlanes, NearestPlaneIsOneThePointIsBeside) {
  Scene scene;
  scene.slices = scene_slices({image_at(0, "a"), image_at(4, "b")});
  const std::vector<ViewPlane> planes = view_planes(scene);
  EXPECT_EQ(plane_nearest_to({0, 0, 2.5}, planes), 1U);
  EXPECT_EQ(plane_nearest_to({0, 0, -7}, planes), 0U);
  EXPECT_FALSE(plane_nearest_to({100, 0, 0}, planes).has_value());
}

}  // namespace
}  // namespace isostack

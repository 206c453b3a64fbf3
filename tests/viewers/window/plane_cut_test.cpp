#include "viewers/window/plane_cut.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

TEST(PlaneCut, ComparesTheCutWithTheContourDrawnThere) {
  Scene scene;
  scene.surfaces = scene_surfaces({testing_support::sphere_mesh({0, 0, 0}, 12, 200, 100)});
  scene.contours = scene_contours({testing_support::sphere_cuts(10, {}, {0, 11}, 200)});
  const std::vector<ViewPlane> planes = view_planes(scene);
  const PlaneCut cut = cut_by_plane(planes[0], scene, {0});
  ASSERT_EQ(cut.lines.size(), 1U);
  ASSERT_EQ(cut.lines[0].contours.size(), 1U);
  for (const Eigen::Vector2d& point : cut.lines[0].contours[0].points_mm)
    EXPECT_NEAR(planes[0].pose.slice_to_world(point).norm(), 12, 0.01);  // the mesh's chords are 0.006 mm off
  ASSERT_EQ(cut.agreements.size(), 1U);
  EXPECT_NEAR(cut.agreements[0].of_slice.mean_mm, 2, 0.01);
  EXPECT_EQ(to_text(cut, scene), "sphere: surface 2.00 mm mean, 2.00 mm largest from the contour");
}

TEST(PlaneCut, HiddenSurfacesAndOrgansWithoutASurface) {
  Scene scene;
  scene.surfaces = scene_surfaces({testing_support::sphere_mesh({0, 0, 0}, 12, 40, 20)});
  scene.contours = scene_contours({testing_support::sphere_cuts(10, {}, {0}, 40)});
  const std::vector<ViewPlane> planes = view_planes(scene);
  EXPECT_TRUE(cut_by_plane(planes[0], scene, {-1}).agreements.empty());
  scene.surfaces[0].visible = false;
  EXPECT_TRUE(cut_by_plane(planes[0], scene, {0}).lines.empty());
}

TEST(PlaneCut, SaysWhenTheSurfaceMissesAContour) {
  Scene scene;
  scene.surfaces = scene_surfaces({testing_support::sphere_mesh({0, 0, 40}, 12, 40, 20)});
  scene.contours = scene_contours({testing_support::sphere_cuts(10, {}, {0}, 40)});
  EXPECT_EQ(to_text(cut_by_plane(view_planes(scene)[0], scene, {0}), scene), "sphere: the surface misses the contour");
}

TEST(PlaneCut, OpenSurfacesHaveLinesToo) {
  TriangleMesh half = testing_support::sphere_mesh({0, 0, 0}, 12, 80, 40);
  std::erase_if(half.triangles, [&](const Eigen::Vector3i& corners) {
    const auto is_left = [&](int vertex) { return half.vertices_mm[static_cast<std::size_t>(vertex)].x() < -0.1; };
    return is_left(corners[0]) || is_left(corners[1]) || is_left(corners[2]);
  });
  Scene scene;
  scene.surfaces = scene_surfaces({half});
  scene.contours = scene_contours({testing_support::sphere_cuts(10, {}, {0.1, 11}, 200)});
  const PlaneCut cut = cut_by_plane(view_planes(scene)[0], scene, {0});
  ASSERT_EQ(cut.lines.size(), 1U);
  ASSERT_EQ(cut.lines[0].contours.size(), 1U);
  EXPECT_NEAR(perimeter_mm(cut.lines[0].contours[0]), 2 * std::numbers::pi * 12, 2);  // a half circle there and back
}

}  // namespace
}  // namespace isostack

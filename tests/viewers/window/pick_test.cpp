#include "viewers/window/pick.h"

#include <gtest/gtest.h>

#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::box_mesh;

/// A box of 2 × 4 × 6 mm about the origin.
std::vector<SceneSurface> a_box() { return scene_surfaces({box_mesh({-1, -2, -3}, {1, 2, 3})}); }

const Ray from_left = {{100, 0.5, 0.25}, {-1, 0, 0}};

TEST(Pick, FirstSurfaceAlongTheRay) {
  const auto hit = hit_on_surfaces(from_left, a_box(), std::nullopt);
  ASSERT_TRUE(hit.has_value());
  EXPECT_TRUE(hit->isApprox(Eigen::Vector3d(1, 0.5, 0.25), 1e-12));
  EXPECT_FALSE(hit_on_surfaces({{100, 5, 0}, {-1, 0, 0}}, a_box(), std::nullopt)) << "beside the box";
  EXPECT_FALSE(hit_on_surfaces({{100, 0, 0}, {1, 0, 0}}, a_box(), std::nullopt)) << "behind the viewer";
}

TEST(Pick, WhatIsClippedOrHiddenIsNotHit) {
  const ClipPlane only_right = Eigen::Hyperplane<double, 3>(Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d::Zero());
  const auto hit = hit_on_surfaces(from_left, a_box(), only_right);
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->x(), -1, 1e-12) << "the inner side of the far face";
  std::vector<SceneSurface> hidden = a_box();
  hidden[0].visible = false;
  EXPECT_FALSE(hit_on_surfaces(from_left, hidden, std::nullopt));
}

TEST(Pick, PlanesAreHitWithinTheirExtent) {
  ViewPlane plane;
  plane.pose.origin_mm = {0, 0, 7};
  plane.extent_mm = {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)};
  const Eigen::Vector3d oblique = Eigen::Vector3d(0, 3, -4) / 5;
  const auto hit = hit_on_plane({{5, 2, 11}, oblique}, plane);
  ASSERT_TRUE(hit.has_value());
  EXPECT_TRUE(hit->isApprox(Eigen::Vector3d(5, 5, 7), 1e-12));
  EXPECT_FALSE(hit_on_plane({{50, 2, 11}, oblique}, plane));
  EXPECT_FALSE(hit_on_plane({{5, 2, 11}, {1, 0, 0}}, plane)) << "along the plane";
}

TEST(Pick, FactsAreThoseOfThePlaneAndTheSurfaces) {
  Scene scene;
  Slice image{.name = "image", .pose = {}, .pixels = Image<float>::Zero(10, 10)};
  image.pose.origin_mm = {-5, -5, 0};
  image.pixels(7, 6) = 42;  // row 7, column 6: at (1, 2, 0)
  scene.slices = scene_slices({image});
  scene.surfaces = a_box();
  scene.contours = scene_contours({testing_support::sphere_cuts(3, {}, {0}, 40)});
  const std::vector<ViewPlane> planes = view_planes(scene);
  const PointFacts facts = facts_about({1.3, 2.2, 0}, scene, &planes[0]);
  EXPECT_EQ(facts.grey, 42.0F);
  EXPECT_EQ(facts.inside, std::vector<std::string>{"sphere"});
  ASSERT_EQ(facts.surfaces.size(), 1U);
  EXPECT_NEAR(facts.surfaces[0].distance_mm, std::hypot(0.3, 0.2), 1e-12) << "to the box's edge at (1, 2)";
  EXPECT_EQ(to_text(facts), "L 1.3  P 2.2  S 0.0 mm   value 42   in sphere   0.36 mm from box");

  const PointFacts beside_plane = facts_about({1.3, 2.2, 2}, scene, &planes[0]);
  EXPECT_FALSE(beside_plane.grey.has_value());
  EXPECT_TRUE(beside_plane.inside.empty());
  EXPECT_FALSE(facts_about({50, 0, 0}, scene, &planes[0]).grey.has_value()) << "beside the image";
}

}  // namespace
}  // namespace isostack

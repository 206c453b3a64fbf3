#include "recon/surface/plane_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using namespace testing_support;

SlicePose pose_at(const Eigen::Vector3d& origin, const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  SlicePose pose;
  pose.origin_mm = origin;
  pose.x_axis = x;
  pose.y_axis = y;
  return pose;
}

TEST(PlaneSection, OfASphereIsACircle) {
  const double radius = 20, height = 12, in_plane = 16;  // 12² + 16² = 20²
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d centre(3, 4, 5);
  const SlicePose pose = pose_at(centre + height * turn.col(2), turn.col(0), turn.col(1));
  const auto contours = plane_section(sphere_mesh(centre, radius, 240, 160), pose);
  ASSERT_EQ(contours.size(), 1u);
  const double sagitta = 0.01;  // facets of 1.5° lie 20 mm · (1 − cos 0.75°) = 0.0017 within, more on the diagonal
  for (const Eigen::Vector2d& p : contours[0].points_mm) EXPECT_NEAR(p.norm(), in_plane, sagitta);
  EXPECT_NEAR(signed_area_mm2(contours[0]), std::numbers::pi * in_plane * in_plane, 1.0);  // 804 mm², facets within
}

TEST(PlaneSection, OfATorusThroughItsRingIsACurveAndAHole) {
  const auto contours = plane_section(torus_mesh(20, 6, 180, 90), SlicePose{});
  ASSERT_EQ(contours.size(), 2u);
  double area = 0;
  for (const Contour& contour : contours) area += signed_area_mm2(contour);
  EXPECT_NEAR(area, std::numbers::pi * (26 * 26 - 14 * 14), 2);  // 1508 mm²; 180 corners lose 0.02 %
  EXPECT_EQ(contours[0].depth + contours[1].depth, 1);
}

TEST(PlaneSection, ThroughAFaceOfABoxIsThereOrNotButClosed) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {10, 10, 10});
  const SlicePose bottom = pose_at({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), top = pose_at({0, 0, 10}, {1, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(plane_section(box, bottom).empty());  // vertices in the plane count as above: all are
  const auto at_top = plane_section(box, top);
  ASSERT_EQ(at_top.size(), 1u);
  EXPECT_NEAR(signed_area_mm2(at_top[0]), 100, 1e-9);
}

/// A sphere about the origin without the triangles that reach below this x.
TriangleMesh cut_open(double x_mm) {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 20, 120, 80);
  std::erase_if(mesh.triangles, [&](const Eigen::Vector3i& t) {
    return std::min({mesh.vertices_mm[static_cast<std::size_t>(t[0])].x(),
                     mesh.vertices_mm[static_cast<std::size_t>(t[1])].x(),
                     mesh.vertices_mm[static_cast<std::size_t>(t[2])].x()}) < x_mm;
  });
  return mesh;
}

TEST(PlaneSection, OfAnOpenMeshIsALineFromEdgeToEdge) {
  const TriangleMesh open = cut_open(-10);
  const SlicePose equator = pose_at({0, 0, 0.1}, {1, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(plane_section(open, equator).empty());
  const SectionLines lines = section_lines(open, equator);
  ASSERT_EQ(lines.open.size(), 1u);
  const std::vector<Eigen::Vector2d>& line = lines.open[0];
  double length_mm = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length_mm += (line[i] - line[i - 1]).norm();
  EXPECT_NEAR(length_mm, 20 * 2 * (std::numbers::pi - std::acos(0.5)), 2.2);  // two triangles of 1.05 mm at the ends
  EXPECT_LT(line.front().x(), -8.5);
  EXPECT_LT(line.back().x(), -8.5);
  EXPECT_GT(std::abs(line.front().y() - line.back().y()), 30);
}

TEST(PlaneSection, OfAMeshOpenElsewhereIsClosed) {
  const SectionLines lines = section_lines(cut_open(-10), pose_at({12, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_TRUE(lines.open.empty());
  ASSERT_EQ(lines.closed.size(), 1u);
  EXPECT_NEAR(signed_area_mm2(lines.closed[0]), std::numbers::pi * 16 * 16, 2);
}

TEST(PlaneSection, BesideTheMeshIsEmpty) {
  EXPECT_TRUE(plane_section(box_mesh({0, 0, 1}, {1, 1, 2}), SlicePose{}).empty());
}

}  // namespace
}  // namespace isostack

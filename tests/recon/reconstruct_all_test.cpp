#include "recon/reconstruct_all.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/metrics/voxelize.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;

/// The half of a disc with x > 0 (side 1) or x < 0 (side −1).
Contour half_disc(double radius_mm, double side) {
  Contour contour;
  const int on_arc = 100, on_face = 60;
  for (int i = 0; i < on_arc; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / on_arc - 0.5);
    contour.points_mm.emplace_back(side * radius_mm * std::cos(angle), radius_mm * std::sin(angle));
  }
  for (int i = 0; i < on_face; ++i) contour.points_mm.emplace_back(0, radius_mm * (1 - 2.0 * i / on_face));
  if (side < 0) std::reverse(contour.points_mm.begin(), contour.points_mm.end());  // the organ on the left again
  return contour;
}

/// The half of a sphere of radius 30 mm with x > 0 (side 1) or x < 0 (side −1), cut at z = −24 … 24.
ContourStack half_sphere(double side) {
  ContourStack stack{.name = side > 0 ? "right" : "left", .slices = {}};
  for (double z = -24; z <= 24; z += 8) {
    ContourSlice slice{.name = "slice", .pose = {}, .contours = {half_disc(std::sqrt(900 - z * z), side)}};
    slice.pose.origin_mm.z() = z;
    stack.slices.push_back(slice);
  }
  return stack;
}

/// Voxels of half a millimetre inside both surfaces, as a share of those inside either.
double overlapping_share(const TriangleMesh& a, const TriangleMesh& b, const Eigen::AlignedBox3d& box) {
  Grid grid;
  grid.size = (box.sizes() / 0.5).array().ceil().cast<int>();
  grid.index_to_world = Eigen::Translation3d(box.min()) * Eigen::Scaling(0.5);
  LabelVolume in_a(grid), in_b(grid);
  voxelize(a, 1, in_a);
  voxelize(b, 1, in_b);
  double both = 0, either = 0;
  for (std::size_t i = 0; i < in_a.voxels.size(); ++i) {
    both += in_a.voxels[i] != 0 && in_b.voxels[i] != 0;
    either += in_a.voxels[i] != 0 || in_b.voxels[i] != 0;
  }
  return both / either;
}

/// Two balls of radius 20 mm that overlap by `overlap_mm`, centres on the x axis; drawn in the same planes, or the
/// right one in planes across those of the left one.
std::vector<ContourStack> two_balls(double overlap_mm, bool in_same_planes) {
  std::vector<ContourStack> balls;
  for (const double side : {-1.0, 1.0}) {
    SlicePose pose;
    if (side > 0 && !in_same_planes) pose.y_axis = Eigen::Vector3d::UnitZ();
    ContourStack ball = sphere_cuts(20, pose, {-16, -8, 0, 8, 16}, 160);
    ball.name = side < 0 ? "left" : "right";
    for (ContourSlice& slice : ball.slices)
      for (Contour& contour : slice.contours)
        for (Eigen::Vector2d& p : contour.points_mm) p.x() += side * (20 - overlap_mm / 2);
    balls.push_back(ball);
  }
  return balls;
}

TEST(ReconstructAll, OverlappingBallsShareThePlaneHalfWay) {
  const std::vector<ContourStack> balls = two_balls(6, false);
  const std::vector<Reconstruction> cut = reconstruct_all(balls, {});
  ASSERT_EQ(cut.size(), 2u);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-40, -22, -24), Eigen::Vector3d(40, 22, 24));
  EXPECT_LE(overlapping_share(cut[0].surface, cut[1].surface, box), 1e-3);
  EXPECT_GT(overlapping_share(reconstruct_all(balls, {.allow_overlap = true})[0].surface,
                              reconstruct_all(balls, {.allow_overlap = true})[1].surface, box),
            1e-2);
  for (const int side : {0, 1}) {
    EXPECT_TRUE(measure(cut[static_cast<std::size_t>(side)].surface).watertight());
    int on_face = 0;
    const TriangleMesh& mesh = cut[static_cast<std::size_t>(side)].surface;
    for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
      const Eigen::Vector3d& v = mesh.vertices_mm[i];
      if (std::hypot(v.y(), v.z()) > 8 || std::abs(v.x()) > 5) continue;  // the face has a radius of 10.5 mm
      EXPECT_NEAR(v.x(), 0, 0.15) << "the balls meet in the plane x = 0, but for 0.1 mm between slices";
      EXPECT_GT(mesh.normals[i].x() * (side == 0 ? 1 : -1), 0.95);
      ++on_face;
    }
    EXPECT_GT(on_face, 100);
    EXPECT_EQ(cut[static_cast<std::size_t>(side)].report.shares_faces_with.size(), 1u);
  }
}

TEST(ReconstructAll, WhatWasDrawnOverlappingStaysSo) {
  const std::vector<Reconstruction> drawn = reconstruct_all(two_balls(6, true), {});
  // The lens two balls have in common is 1.7 % of both: π (4 r + d) (2 r − d)² / 12 each way, d = 34 mm.
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-40, -22, -24), Eigen::Vector3d(40, 22, 24));
  EXPECT_GT(overlapping_share(drawn[0].surface, drawn[1].surface, box), 1e-2);
  EXPECT_TRUE(drawn[0].report.shares_faces_with.empty());
}

TEST(ReconstructAll, HalfSpheresMeetInTheirCommonFace) {
  const std::vector<Reconstruction> halves = reconstruct_all({half_sphere(-1), half_sphere(1)}, {});
  const Eigen::AlignedBox3d box(Eigen::Vector3d::Constant(-34), Eigen::Vector3d::Constant(34));
  EXPECT_LE(overlapping_share(halves[0].surface, halves[1].surface, box), 1e-3);
  std::vector<Eigen::Vector3d> on_face;
  for (const Eigen::Vector3d& v : halves[0].surface.vertices_mm)
    if (v.x() > -2 && std::hypot(v.y(), v.z()) < 22) on_face.push_back(v);
  ASSERT_GT(on_face.size(), 500u);
  std::vector<double> apart = distances_to_mesh_mm(on_face, halves[1].surface);
  std::sort(apart.begin(), apart.end());
  // Where the functions overlap the face is one; where both are slightly negative between slices a thin gap is left.
  EXPECT_LT(apart[apart.size() / 2], 0.01);
  EXPECT_LT(apart[apart.size() * 9 / 10], 0.15);
  EXPECT_LT(apart.back(), 0.25);  // a quarter of a pixel
}

TEST(ReconstructAll, OrgansThatDoNotTouchAreUntouched) {
  const std::vector<ContourStack> balls = two_balls(-3, true);
  const std::vector<Reconstruction> together = reconstruct_all(balls, {});
  for (std::size_t i = 0; i < 2; ++i) {
    const Reconstruction alone = reconstruct(balls[i], {});
    EXPECT_EQ(together[i].surface.name, balls[i].name);
    EXPECT_EQ(together[i].surface.triangles.size(), alone.surface.triangles.size());
    ASSERT_EQ(together[i].surface.vertices_mm.size(), alone.surface.vertices_mm.size());
    for (std::size_t v = 0; v < alone.surface.vertices_mm.size(); ++v)
      ASSERT_EQ(together[i].surface.vertices_mm[v], alone.surface.vertices_mm[v]);
    EXPECT_TRUE(together[i].report.shares_faces_with.empty());
  }
}

}  // namespace
}  // namespace isostack

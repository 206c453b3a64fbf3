// Values shown on surfaces, and lighter stand-ins for large ones, against balls whose answers are known.
#include "viewers/surface_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "viewers/mesh_proxy.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;

constexpr double radius_mm = 30;
// Faces of a ball of 96 × 48 lie this far inside it at most.
const double sagitta_mm = radius_mm * (1 - std::cos(std::numbers::pi / 48));

TriangleMesh ball(double radius) { return sphere_mesh({5, -6, 7}, radius, 96, 48); }

TEST(DistanceValues, AreSignedByTheSideOfAClosedSurface) {
  const VertexValues outside = distance_values(ball(radius_mm + 2), ball(radius_mm), "ball");
  for (const double distance : outside.values) EXPECT_NEAR(distance, 2, 2 * sagitta_mm);
  const VertexValues inside = distance_values(ball(radius_mm - 2), ball(radius_mm), "ball");
  for (const double distance : inside.values) EXPECT_NEAR(distance, -2, 2 * sagitta_mm);
  EXPECT_EQ(inside.range.map, ColourMap::diverging);
  EXPECT_NE(inside.label.find("ball"), std::string::npos);
  EXPECT_NE(inside.label.find("mm"), std::string::npos);
}

TEST(DistanceValues, HaveNoSignBesideAnOpenSurface) {
  TriangleMesh open = ball(radius_mm);
  open.triangles.resize(open.triangles.size() / 2);
  const VertexValues values = distance_values(ball(radius_mm - 2), open, "bowl");
  EXPECT_GE(*std::min_element(values.values.begin(), values.values.end()), 0);
}

TEST(CurvatureValues, OfABallAreOneOverItsRadius) {
  const VertexValues values = curvature_values(ball(radius_mm));
  const auto middle = values.values.begin() + static_cast<std::ptrdiff_t>(values.values.size() / 2);
  EXPECT_NEAR(*middle, 1 / radius_mm, 0.02 / radius_mm);
  EXPECT_EQ(values.range.low, -values.range.high);
}

ContourStack ring(double radius) {
  ContourStack stack{.name = "ring", .slices = {ContourSlice{}}};
  stack.slices[0].pose.origin_mm = {5, -6, 7};
  Contour contour;
  for (int i = 0; i < 360; ++i)
    contour.points_mm.emplace_back(radius * std::cos(i * std::numbers::pi / 180),
                                   radius * std::sin(i * std::numbers::pi / 180));
  stack.slices[0].contours = {contour};
  return stack;
}

TEST(ResidualValues, AreHowFarTheNearestContourPointIsOff) {
  const VertexValues values = residual_values(ball(radius_mm), ring(radius_mm + 1.5));
  for (const double residual : values.values) EXPECT_NEAR(residual, 1.5, 2 * sagitta_mm);
  EXPECT_THROW(residual_values(ball(radius_mm), ContourStack{}), InputError);
}

TEST(MeshProxy, IsMuchSmallerAndLiesOnTheSameBody) {
  const TriangleMesh fine = sphere_mesh({5, -6, 7}, radius_mm, 400, 200);
  const MeshProxy proxy = mesh_proxy(fine, 10'000);
  EXPECT_LT(proxy.mesh.triangles.size(), 20'000u);
  EXPECT_GT(proxy.mesh.triangles.size(), 3'000u);
  ASSERT_EQ(proxy.source_vertex.size(), proxy.mesh.vertices_mm.size());
  const double cell_mm = std::sqrt(3 * 4 * std::numbers::pi * radius_mm * radius_mm / 10'000);
  for (std::size_t i = 0; i < proxy.source_vertex.size(); ++i) {
    EXPECT_NEAR((proxy.mesh.vertices_mm[i] - Eigen::Vector3d(5, -6, 7)).norm(), radius_mm, cell_mm / 2);
    EXPECT_LT((proxy.mesh.vertices_mm[i] - fine.vertices_mm[proxy.source_vertex[i]]).norm(), std::sqrt(3) * cell_mm);
  }
}

}  // namespace
}  // namespace isostack

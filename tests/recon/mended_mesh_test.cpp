#include "recon/distance/mended_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using Eigen::Vector3d;
using testing_support::sphere_mesh;

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const int offset = static_cast<int>(a.vertices_mm.size());
  a.vertices_mm.insert(a.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back(t.array() + offset);
  return a;
}

TriangleMesh turned(TriangleMesh mesh) {
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

double ball_mm3(double radius_mm) { return 4.0 / 3 * std::numbers::pi * std::pow(radius_mm, 3); }

TEST(MendedMesh, OverlappingPartsAreRefusedOrUnited) {
  const TriangleMesh two = together(sphere_mesh({0, 0, 0}, 20, 60, 30), sphere_mesh({20, 0, 0}, 20, 60, 30));
  EXPECT_THROW(require_no_overlap(two), InputError);
  const MendedMesh mended = mended_mesh(two);
  EXPECT_EQ(mended.remarks.size(), 2u);
  const MeshMeasures measures = measure(mended.mesh);
  EXPECT_TRUE(measures.watertight());
  EXPECT_EQ(measures.components, 1u);
  // Two balls a radius apart share 5/16 of a ball. 1 %: a sphere of 60 × 30 quadrilaterals lacks 0.7 %.
  EXPECT_NEAR(measures.volume_mm3, (2 - 5.0 / 16) * ball_mm3(20), 0.01 * ball_mm3(20) * 1.7);
}

TEST(MendedMesh, HolesAndTurnedTrianglesAreMendedAndTold) {
  TriangleMesh open = sphere_mesh({5, 0, 0}, 20, 60, 30);
  open.triangles.resize(open.triangles.size() - 4);
  const MendedMesh closed = mended_mesh(open);
  EXPECT_NE(closed.remarks.at(0).find("not closed"), std::string::npos);
  EXPECT_TRUE(measure(closed.mesh).watertight());
  EXPECT_NEAR(measure(closed.mesh).volume_mm3, ball_mm3(20), 0.015 * ball_mm3(20));

  TriangleMesh confused = sphere_mesh({5, 0, 0}, 20, 60, 30);
  for (std::size_t t = 0; t < confused.triangles.size(); t += 5)
    std::swap(confused.triangles[t][1], confused.triangles[t][2]);
  const MendedMesh sorted = mended_mesh(confused);
  EXPECT_NE(sorted.remarks.at(0).find("disagree"), std::string::npos);
  EXPECT_NEAR(measure(sorted.mesh).volume_mm3, ball_mm3(20), 0.015 * ball_mm3(20));
  EXPECT_GT(measure(mended_mesh(turned(sphere_mesh({0, 0, 0}, 20, 20, 10))).mesh).volume_mm3, 0);
}

TEST(MendedMesh, SoundMeshesStayAsTheyAre) {
  const TriangleMesh ball = sphere_mesh({0, 0, 0}, 20, 40, 20);
  EXPECT_EQ(mended_mesh(ball).mesh.vertices_mm, ball.vertices_mm);
  EXPECT_TRUE(mended_mesh(ball).remarks.empty());
  // A cavity is not enclosed twice, two parts beside each other neither; a ball within a ball is.
  EXPECT_NO_THROW(require_no_overlap(together(ball, turned(sphere_mesh({0, 0, 0}, 10, 40, 20)))));
  EXPECT_NO_THROW(require_no_overlap(together(ball, sphere_mesh({41, 0, 0}, 20, 40, 20))));
  EXPECT_THROW(require_no_overlap(together(ball, sphere_mesh({0, 0, 0}, 10, 40, 20))), InputError);
}

TEST(MendedMesh, WhatEnclosesNothingIsRefused) {
  TriangleMesh sheet{
      .name = "sheet", .vertices_mm = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, .triangles = {{0, 1, 2}}, .normals = {}};
  EXPECT_THROW(mended_mesh(sheet), InputError);
  EXPECT_THROW(mended_mesh({}), InputError);
}

}  // namespace
}  // namespace isostack

#include "recon/metrics/mesh_curvature.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;
using testing_support::torus_mesh;

TEST(MeshCurvature, OfASphereIsOneOverItsRadius) {
  const Eigen::Vector3d centre(3, -2, 8);
  TriangleMesh sphere = sphere_mesh(centre, 25, 96, 48);
  const CurvatureRange means = mean_curvature_range_per_mm(sphere);
  // Without normals they are means over faces, which the slim ones at the poles bend.
  EXPECT_NEAR(means.percentile1, 1.0 / 25, 0.1 / 25);
  EXPECT_NEAR(means.percentile99, 1.0 / 25, 0.1 / 25);
  for (const Eigen::Vector3d& vertex : sphere.vertices_mm) sphere.normals.push_back((vertex - centre).normalized());
  const CurvatureRange exact = mean_curvature_range_per_mm(sphere);
  EXPECT_NEAR(exact.lowest, 1.0 / 25, 1e-9);
  EXPECT_NEAR(exact.highest, 1.0 / 25, 1e-9);
}

TEST(MeshCurvature, OfATorusIsThatOfItsFormula) {
  const double ring = 30, tube = 9;
  const CurvatureRange range = mean_curvature_range_per_mm(torus_mesh(ring, tube, 160, 60));
  // (R + 2 r cos v) / (2 r (R + r cos v)), at the outer and the inner equator.
  EXPECT_NEAR(range.highest, (ring + 2 * tube) / (2 * tube * (ring + tube)), 0.02 / tube);
  EXPECT_NEAR(range.lowest, (ring - 2 * tube) / (2 * tube * (ring - tube)), 0.02 / tube);
  EXPECT_LT(range.percentile99, range.highest);
  EXPECT_GT(range.percentile1, range.lowest);
}

TEST(MeshCurvature, IsNegativeInAHollowAndTakesTheMeshsNormals) {
  TriangleMesh hollow = sphere_mesh(Eigen::Vector3d::Zero(), 10, 64, 32);
  for (Eigen::Vector3i& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
  for (const Eigen::Vector3d& vertex : hollow.vertices_mm) hollow.normals.push_back(-vertex.normalized());
  for (const double curvature : mean_curvatures_per_mm(hollow)) EXPECT_NEAR(curvature, -0.1, 1e-3);
}

TEST(MeshCurvature, NeedlesAndNothingDoNoHarm) {
  EXPECT_EQ(mean_curvature_range_per_mm(TriangleMesh{}).highest, 0);
  TriangleMesh sphere = sphere_mesh(Eigen::Vector3d::Zero(), 10, 64, 32);
  for (const Eigen::Vector3d& vertex : sphere.vertices_mm) sphere.normals.push_back(vertex.normalized());
  sphere.triangles.emplace_back(0, 1, 0);
  EXPECT_NEAR(mean_curvature_range_per_mm(sphere).highest, 0.1, 1e-9);
}

}  // namespace
}  // namespace isostack

#include "recon/metrics/mesh_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using namespace testing_support;

TriangleMesh tetrahedron() {
  return {.name = "tetrahedron",
          .vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          .normals = {}};
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int offset = static_cast<int>(a.vertices_mm.size());
  a.vertices_mm.insert(a.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back((t.array() + offset).matrix());
  return a;
}

TEST(MeshMeasures, Tetrahedron) {
  const MeshMeasures m = measure(tetrahedron());
  EXPECT_NEAR(m.volume_mm3, 1.0 / 6, 1e-15);
  EXPECT_NEAR(m.area_mm2, 1.5 + std::sqrt(3.0) / 2, 1e-14);
  EXPECT_EQ(m.vertices, 4u);
  EXPECT_EQ(m.triangles, 4u);
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.euler_characteristic, 2);
  EXPECT_EQ(m.genus, 0);
  EXPECT_TRUE(m.watertight());
}

TEST(MeshMeasures, BoxFarFromTheOriginKeepsItsDigits) {
  const Eigen::Vector3d far(1e5, -2e5, 3e5);
  const MeshMeasures m = measure(box_mesh(far, far + Eigen::Vector3d(2, 3, 4)));
  EXPECT_NEAR(m.volume_mm3, 24, 1e-8);  // coordinates of 3e5 resolve 6e-11
  EXPECT_NEAR(m.area_mm2, 52, 1e-8);
  EXPECT_TRUE(m.watertight());
}

TEST(MeshMeasures, MeasuresDoNotDependOnThePose) {
  Eigen::Isometry3d motion(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(-40, 7, 900));
  const MeshMeasures m = measure(moved(box_mesh({0, 0, 0}, {2, 3, 4}), motion));
  EXPECT_NEAR(m.volume_mm3, 24, 1e-10);
  EXPECT_NEAR(m.area_mm2, 52, 1e-10);
}

TEST(MeshMeasures, InsideOutHasNegativeVolume) {
  TriangleMesh mesh = tetrahedron();
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(measure(mesh).volume_mm3, -1.0 / 6, 1e-15);
  EXPECT_TRUE(measure(mesh).watertight()) << "consistent, if inside out";
}

TEST(MeshMeasures, AFlippedTriangleShowsAtItsThreeEdges) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.flipped_edges, 3u);
  EXPECT_EQ(m.boundary_edges, 0u);
  EXPECT_FALSE(m.watertight());
}

TEST(MeshMeasures, AMissingTriangleShowsAtItsThreeEdges) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.boundary_edges, 3u);
  EXPECT_EQ(m.flipped_edges, 0u);
  EXPECT_EQ(m.euler_characteristic, 1);
  EXPECT_FALSE(m.watertight());
}

TEST(MeshMeasures, AFinIsNotManifold) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices_mm.emplace_back(1, 1, -1);
  mesh.triangles.emplace_back(0, 1, 4);
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.non_manifold_edges, 1u);
  EXPECT_EQ(m.boundary_edges, 2u);
  EXPECT_FALSE(m.watertight());
}

TEST(MeshMeasures, TorusHasOneHandleAndPappusVolume) {
  const double ring = 20, tube = 6;
  const MeshMeasures m = measure(torus_mesh(ring, tube, 240, 160));
  EXPECT_EQ(m.euler_characteristic, 0);
  EXPECT_EQ(m.genus, 1);
  EXPECT_EQ(m.components, 1u);
  EXPECT_TRUE(m.watertight());
  const double volume = 2 * std::pow(std::numbers::pi * tube, 2) * ring;
  const double area = 4 * std::pow(std::numbers::pi, 2) * ring * tube;
  EXPECT_NEAR(m.volume_mm3, volume, 1e-3 * volume);  // inscribed: (2π/160)²/6 + (2π/240)²/6 ≈ 4·10⁻⁴
  EXPECT_LT(m.volume_mm3, volume);
  EXPECT_NEAR(m.area_mm2, area, 1e-3 * area);
}

TEST(MeshMeasures, CountsComponentsAndOnlyUsedVertices) {
  TriangleMesh mesh = joined(torus_mesh(20, 6, 30, 20), box_mesh({50, 0, 0}, {60, 10, 10}));
  mesh.vertices_mm.emplace_back(0, 0, 0);  // nobody's
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.components, 2u);
  EXPECT_EQ(m.vertices, 600u + 8u);
  EXPECT_EQ(m.genus, 1) << "2 − (0 + 2)/2";
}

TEST(MeshMeasures, OfAnEmptyMeshAreZero) {
  const MeshMeasures m = measure({});
  EXPECT_EQ(m.volume_mm3, 0);
  EXPECT_EQ(m.components, 0u);
  EXPECT_EQ(m.triangles, 0u);
}

TEST(MeshMeasures, RefusesTrianglesWithoutTheirVertex) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles[2] = {0, 1, 4};
  EXPECT_THROW(measure(mesh), InputError);
  mesh.triangles[2] = {0, -1, 2};
  EXPECT_THROW(measure(mesh), InputError);
}

}  // namespace
}  // namespace isostack

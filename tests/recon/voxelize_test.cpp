#include "recon/metrics/voxelize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using namespace testing_support;

Grid unit_grid(int n) {
  Grid grid;
  grid.size = {n, n, n};
  return grid;
}

/// Turned, anisotropic, sheared along k, round the world's origin.
Grid oblique_grid() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Eigen::Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  Grid grid;
  grid.size = {70, 50, 30};
  grid.index_to_world.linear() << 0.7 * turn.col(0), 0.9 * turn.col(1), 1.7 * (turn.col(2) + 0.2 * turn.col(1));
  grid.index_to_world.translation() = -(grid.index_to_world.linear() * Eigen::Vector3d(34.6, 24.3, 14.8));
  return grid;
}

std::size_t count_of(const LabelVolume& labels, std::uint16_t label) {
  return static_cast<std::size_t>(std::count(labels.voxels.begin(), labels.voxels.end(), label));
}

TEST(Voxelize, SphereOnAnObliqueAnisotropicGrid) {
  const double radius = 18;
  LabelVolume labels(oblique_grid());
  voxelize(sphere_mesh({0, 0, 0}, radius, 200, 120), 3, labels);
  const double volume = 4 * std::numbers::pi * std::pow(radius, 3) / 3;
  // 22,800 voxels; the count of lattice points in a ball is off by far less than its surface's share, 0.5 %.
  EXPECT_NEAR(static_cast<double>(count_of(labels, 3)) * labels.grid.voxel_volume_mm3(), volume, 5e-3 * volume);
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 70; ++i) {
        const double r = (labels.grid.index_to_world * Eigen::Vector3d(i, j, k)).norm();
        if (std::abs(r - radius) < 0.02) continue;  // the mesh lies up to 12 µm within the sphere
        ASSERT_EQ(labels.at(i, j, k) == 3, r < radius) << i << ' ' << j << ' ' << k;
      }
}

TEST(Voxelize, CubeWithFacesOnVoxelCentresHasItsVolume) {
  LabelVolume labels(unit_grid(10));
  voxelize(box_mesh({2, 2, 2}, {6, 6, 6}), 1, labels);
  EXPECT_EQ(count_of(labels, 1), 64u);
}

TEST(Voxelize, CubesThatTouchOnVoxelCentresShareNoVoxelAndLeaveNone) {
  for (int axis = 0; axis < 3; ++axis) {
    LabelVolume first(unit_grid(10)), second(unit_grid(10));
    const Eigen::Vector3d step = 3 * Eigen::Vector3d::Unit(axis);
    voxelize(box_mesh({1, 1, 1}, {4, 4, 4}), 1, first);
    voxelize(box_mesh(Eigen::Vector3d(1, 1, 1) + step, Eigen::Vector3d(4, 4, 4) + step), 1, second);
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < first.voxels.size(); ++i) {
      both += first.voxels[i] != 0 && second.voxels[i] != 0 ? 1 : 0;
      either += first.voxels[i] != 0 || second.voxels[i] != 0 ? 1 : 0;
    }
    EXPECT_EQ(both, 0u) << "axis " << axis;
    EXPECT_EQ(either, 54u) << "axis " << axis;
  }
}

TEST(Voxelize, VerticesOnVoxelCentresLeaveNoStreaks) {
  // An octahedron: |x| + |y| + |z| ≤ 4 with all vertices and many edges on lattice points.
  TriangleMesh mesh;
  mesh.vertices_mm = {{9, 5, 5}, {1, 5, 5}, {5, 9, 5}, {5, 1, 5}, {5, 5, 9}, {5, 5, 1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  LabelVolume labels(unit_grid(11));
  voxelize(mesh, 1, labels);
  for (int k = 0; k < 11; ++k)
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 11; ++i) {
        const int distance = std::abs(i - 5) + std::abs(j - 5) + std::abs(k - 5);
        if (distance == 4) continue;
        ASSERT_EQ(labels.at(i, j, k) == 1, distance < 4) << i << ' ' << j << ' ' << k;
      }
}

TEST(Voxelize, IgnoresOrientationAndKeepsOtherLabels) {
  TriangleMesh mesh = box_mesh({1.5, 1.5, 1.5}, {4.5, 4.5, 4.5});
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[0], t[1]);
  LabelVolume labels(unit_grid(8), 7);
  voxelize(mesh, 2, labels);
  EXPECT_EQ(count_of(labels, 2), 27u);
  EXPECT_EQ(count_of(labels, 7), 512u - 27u);
}

TEST(Voxelize, MeshBeyondTheGridIsClipped) {
  LabelVolume labels(unit_grid(6));
  voxelize(box_mesh({-100, -100, 2.5}, {100, 100, 300}), 1, labels);
  EXPECT_EQ(count_of(labels, 1), 6u * 6 * 3);
}

TEST(Voxelize, CavityOfAHollowBoxStaysEmpty) {
  TriangleMesh mesh = box_mesh({0.5, 0.5, 0.5}, {7.5, 7.5, 7.5});
  const TriangleMesh inner = box_mesh({2.5, 2.5, 2.5}, {5.5, 5.5, 5.5});
  mesh.vertices_mm.insert(mesh.vertices_mm.end(), inner.vertices_mm.begin(), inner.vertices_mm.end());
  for (const Eigen::Vector3i& t : inner.triangles) mesh.triangles.emplace_back(t[0] + 8, t[2] + 8, t[1] + 8);
  LabelVolume labels(unit_grid(9));
  voxelize(mesh, 1, labels);
  EXPECT_EQ(count_of(labels, 1), 343u - 27u);
}

}  // namespace
}  // namespace isostack

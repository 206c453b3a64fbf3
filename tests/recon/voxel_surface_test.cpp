#include "recon/metrics/voxel_surface.h"

#include <gtest/gtest.h>

#include "recon/metrics/mesh_measures.h"

namespace isostack {
namespace {

LabelVolume volume_with(const std::vector<Eigen::Vector3i>& voxels) {
  Grid grid;
  grid.size = {5, 5, 5};
  grid.index_to_world.linear() = Eigen::Vector3d(1, 2, 3).asDiagonal();
  grid.index_to_world.translation() = Eigen::Vector3d(10, 0, 0);
  LabelVolume labels(grid);
  for (const Eigen::Vector3i& v : voxels) labels.at(v.x(), v.y(), v.z()) = 7;
  return labels;
}

TEST(VoxelSurface, OfOneVoxelIsItsBox) {
  const TriangleMesh mesh = voxel_surface(volume_with({{0, 2, 4}}));  // at the border, too
  const MeshMeasures m = measure(mesh);
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.vertices, 8u);
  EXPECT_NEAR(m.volume_mm3, 6, 1e-12);
  EXPECT_NEAR(m.area_mm2, 2 * (1 * 2 + 2 * 3 + 3 * 1), 1e-12);
  for (const Eigen::Vector3d& v : mesh.vertices_mm) EXPECT_NEAR(std::abs(v.x() - 10), 0.5, 1e-12);  // centre ± half
}

TEST(VoxelSurface, FacesOutwardsOnAMirroredGrid) {
  LabelVolume labels = volume_with({{1, 1, 1}, {2, 1, 1}});
  labels.grid.index_to_world.linear().col(1) *= -1;
  EXPECT_NEAR(measure(voxel_surface(labels)).volume_mm3, 12, 1e-12);
}

TEST(VoxelSurface, KeepsVoxelsThatTouchAlongAnEdgeOrACornerApart) {
  const MeshMeasures edge = measure(voxel_surface(volume_with({{1, 1, 1}, {2, 2, 1}})));
  EXPECT_TRUE(edge.watertight());
  EXPECT_EQ(edge.components, 2u);
  const MeshMeasures corner = measure(voxel_surface(volume_with({{1, 1, 1}, {2, 2, 2}})));
  EXPECT_TRUE(corner.watertight());
  EXPECT_EQ(corner.components, 2u);
  EXPECT_EQ(corner.vertices, 16u);
}

TEST(VoxelSurface, OfARingHasAHandle) {
  const MeshMeasures m = measure(voxel_surface(
      volume_with({{1, 1, 2}, {2, 1, 2}, {3, 1, 2}, {3, 2, 2}, {3, 3, 2}, {2, 3, 2}, {1, 3, 2}, {1, 2, 2}})));
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.genus, 1);
  EXPECT_NEAR(m.volume_mm3, 8 * 6, 1e-9);
}

}  // namespace
}  // namespace isostack

#include "recon/geometry/volume.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// Anisotropic, turned, far from the origin; `tilt` shears along k as a tilted gantry does.
Grid oblique_grid(double tilt = 0) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, -2, 1).normalized()).toRotationMatrix();
  Grid grid;
  grid.size = {5, 4, 3};
  grid.index_to_world.linear().col(0) = 0.5 * turn.col(0);
  grid.index_to_world.linear().col(1) = 0.8 * turn.col(1);
  grid.index_to_world.linear().col(2) = 3 * (turn.col(2) + tilt * turn.col(1));
  grid.index_to_world.translation() = Eigen::Vector3d(-120, 45, 800);
  return grid;
}

Volume<float> numbered(const Grid& grid) {
  Volume<float> volume(grid);
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) volume.at(i, j, k) = static_cast<float>(100 * k + 10 * j + i);
  return volume;
}

TEST(Grid, VoxelVolumeIgnoresShearAndHandedness) {
  EXPECT_NEAR(oblique_grid().voxel_volume_mm3(), 0.5 * 0.8 * 3, 1e-12);
  EXPECT_NEAR(oblique_grid(0.3).voxel_volume_mm3(), 0.5 * 0.8 * 3, 1e-12);
  Grid mirrored = oblique_grid();
  mirrored.index_to_world.linear().col(2) *= -1;
  EXPECT_NEAR(mirrored.voxel_volume_mm3(), 0.5 * 0.8 * 3, 1e-12);
}

TEST(Grid, FirstIndexIsFastest) {
  const Volume<float> volume = numbered(oblique_grid());
  ASSERT_EQ(volume.voxels.size(), 60u);
  EXPECT_EQ(volume.voxels[1], 1);
  EXPECT_EQ(volume.voxels[5], 10);
  EXPECT_EQ(volume.voxels[20], 100);
}

TEST(SlicesOf, PixelsLieWhereTheirVoxelsAre) {
  const Volume<float> volume = numbered(oblique_grid(0.3));
  const std::vector<Slice> slices = slices_of(volume, "liver");
  ASSERT_EQ(slices.size(), 3u);
  EXPECT_EQ(slices[2].name, "liver slice 2");
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i) {
        const Slice& slice = slices[static_cast<std::size_t>(k)];
        EXPECT_EQ(slice.pixels(j, i), volume.at(i, j, k));
        const Eigen::Vector3d there = volume.grid.index_to_world * Eigen::Vector3d(i, j, k);
        EXPECT_LT((slice.pose.pixel_to_world({i, j}) - there).norm(), 1e-9);
      }
}

TEST(PoseOfPlane, RefusesAxesSkewedWithinThePlane) {
  Grid grid = oblique_grid();
  grid.index_to_world.linear().col(1) += 0.05 * grid.index_to_world.linear().col(0);
  EXPECT_THROW(pose_of_plane(grid, 0, "x.nii"), GeometryError);
}

TEST(GridOf, GivesBackTheGridItsSlicesCameFrom) {
  for (const double tilt : {0.0, 0.3}) {
    const Grid grid = oblique_grid(tilt);
    const Grid again = grid_of({.name = "stack", .slices = slices_of(numbered(grid), "v"), .warnings = {}});
    EXPECT_EQ(again.size, grid.size);
    EXPECT_LT((again.index_to_world.matrix() - grid.index_to_world.matrix()).norm(), 1e-9);
  }
}

TEST(GridOf, RefusesStacksThatAreNoGrid) {
  const std::vector<Slice> good = slices_of(numbered(oblique_grid()), "v");
  const auto refused = [](std::vector<Slice> slices) {
    try {
      grid_of({.name = "stack", .slices = std::move(slices), .warnings = {}});
    } catch (const GeometryError&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused(good));
  std::vector<Slice> gap = good, resized = good, turned = good, finer = good;
  gap[1].pose.origin_mm += 0.02 * gap[1].pose.normal();
  resized[2].pixels.resize(4, 6);
  std::swap(turned[1].pose.x_axis, turned[1].pose.y_axis);
  finer[2].pose.spacing_mm.x() *= 0.9;
  for (const auto& slices : {gap, resized, turned, finer, {good[0]}}) EXPECT_TRUE(refused(slices));
}

TEST(GridOf, RefusesSlicesOfOnePlane) {
  std::vector<Slice> slices = slices_of(numbered(oblique_grid()), "v");
  const Eigen::Vector3d step = slices[0].pose.x_axis;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].pose.origin_mm = slices[0].pose.origin_mm;
  }
  EXPECT_THROW(grid_of({.name = "repeated", .slices = slices, .warnings = {}}), GeometryError);
  for (std::size_t k = 0; k < slices.size(); ++k) slices[k].pose.origin_mm += static_cast<double>(k) * step;
  EXPECT_THROW(grid_of({.name = "side by side", .slices = slices, .warnings = {}}), GeometryError);
}

TEST(PositionsAlongNormal, MeasureTheGap) {
  const std::vector<double> positions = positions_along_normal_mm(slices_of(numbered(oblique_grid(0.3)), "v"));
  ASSERT_EQ(positions.size(), 3u);
  EXPECT_NEAR(positions[1] - positions[0], 3, 1e-9);  // the shear lies within the planes
  EXPECT_NEAR(positions[2] - positions[0], 6, 1e-9);
  EXPECT_TRUE(positions_along_normal_mm({}).empty());
}

}  // namespace
}  // namespace isostack

#include "recon/metrics/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/geometry/errors.h"
#include "recon/metrics/voxel_surface.h"

namespace isostack {
namespace {

/// A block of voxels of 1 mm, `thickness` of them along k, in a grid of 10 along each axis.
LabelVolume block(int thickness) {
  Grid grid;
  grid.size = {10, 10, 10};
  LabelVolume labels(grid);
  for (int k = 2; k < 2 + thickness; ++k)
    for (int j = 2; j < 8; ++j)
      for (int i = 2; i < 8; ++i) labels.at(i, j, k) = 1;
  return labels;
}

TEST(Compare, MeshesOfTwoBlocks) {
  const MeasuredBody thick = measured(voxel_surface(block(6))), thin = measured(voxel_surface(block(3)));
  const BodyComparison found = compare(thick, thin);
  EXPECT_NEAR(found.volume_difference_mm3, 6 * 6 * 3, 1e-9);
  EXPECT_NEAR(found.area_difference_mm2.value(), 4 * 6 * 3, 1e-9);
  EXPECT_NEAR(found.dice, 2.0 * 3 / (6 + 3), 0.03);  // on voxels of a 200th of the diagonal
  EXPECT_NEAR(found.distance.largest_mm, 3, 0.01);   // the upper faces
  EXPECT_NEAR(found.diagonal_mm, std::sqrt(6.0 * 6 + 6 * 6 + 3 * 3), 1e-9);
}

TEST(Compare, LabelsCountTheirOwnVoxelsAndHaveNoAreaDifference) {
  const BodyComparison found = compare(measured(block(6), "a"), measured(block(3), "b"));
  EXPECT_DOUBLE_EQ(found.dice, 2.0 * 3 / (6 + 3));
  EXPECT_FALSE(found.area_difference_mm2);
}

TEST(Compare, RefusesEmptyLabelsAndOtherGrids) {
  Grid grid;
  grid.size = {3, 3, 3};
  EXPECT_THROW(measured(LabelVolume(grid), "empty"), InputError);
  LabelVolume moved = block(3);
  moved.grid.index_to_world.translation().x() = 5;
  EXPECT_THROW(compare(measured(block(3), "a"), measured(moved, "b")), InputError);
}

}  // namespace
}  // namespace isostack

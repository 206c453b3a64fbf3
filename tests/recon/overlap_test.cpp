#include "recon/metrics/overlap.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// Columns [first, last) of a 10 × 4 × 2 grid of 0.5 × 1 × 3 mm voxels carry the label.
LabelVolume columns(int first, int last, std::uint16_t label = 1) {
  Grid grid;
  grid.size = {10, 4, 2};
  grid.index_to_world.linear().diagonal() << 0.5, 1, 3;
  LabelVolume labels(grid);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = first; i < last; ++i) labels.at(i, j, k) = label;
  return labels;
}

TEST(Overlap, DiceOfPartlyOverlappingBoxes) {
  const Overlap result = overlap(columns(0, 6), columns(4, 8));
  EXPECT_DOUBLE_EQ(result.dice, 2.0 * 2 / (6 + 4));
  EXPECT_DOUBLE_EQ(result.volume_a_mm3, 6 * 8 * 1.5);
  EXPECT_DOUBLE_EQ(result.volume_b_mm3, 4 * 8 * 1.5);
}

TEST(Overlap, AnyLabelButZeroCounts) { EXPECT_DOUBLE_EQ(overlap(columns(2, 7, 1), columns(2, 7, 9)).dice, 1); }

TEST(Overlap, OfNothingWithNothingIsPerfectAndWithSomethingNil) {
  EXPECT_DOUBLE_EQ(overlap(columns(0, 0), columns(0, 0)).dice, 1);
  EXPECT_DOUBLE_EQ(overlap(columns(0, 0), columns(0, 1)).dice, 0);
  EXPECT_DOUBLE_EQ(overlap(columns(0, 3), columns(3, 6)).dice, 0);
}

TEST(Overlap, RefusesDifferentSizes) {
  Grid small;
  small.size = {10, 4, 1};
  EXPECT_THROW(overlap(columns(0, 1), LabelVolume(small)), InputError);
}

}  // namespace
}  // namespace isostack

#include "recon/metrics/leave_out.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// The circle a sphere of 20 mm round (32, 32, 0) leaves in the plane z, and none beyond its poles; 1 mm pixels.
ContourSlice sphere_slice(double z_mm) {
  ContourSlice slice;
  slice.name = "z";
  slice.pose.origin_mm.z() = z_mm;
  slice.size_pixels = {65, 65};
  if (std::abs(z_mm) >= 20) return slice;
  Contour contour;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * std::numbers::pi * i / 120;
    contour.points_mm.push_back(Eigen::Vector2d(32, 32) +
                                std::sqrt(400 - z_mm * z_mm) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  slice.contours.push_back(contour);
  return slice;
}

ContourStack sphere_stack(double first_mm, double step_mm) {
  ContourStack stack{"sphere", {}};
  for (double z = first_mm; std::abs(z) <= std::abs(first_mm) + 1e-9; z += step_mm)
    stack.slices.push_back(sphere_slice(z));
  return stack;
}

TEST(SplitSlices, KeepsFromTheFirstGivenAndComparesBetweenKeptOnes) {
  for (const double direction : {1.0, -1.0}) {
    const SliceSplit split = split_slices(sphere_stack(-9 * direction, 2 * direction), 4);  // ten slices
    EXPECT_EQ(split.kept, (std::vector<std::size_t>{0, 4, 8}));
    EXPECT_EQ(split.dropped, (std::vector<std::size_t>{1, 2, 3, 5, 6, 7})) << "the last lies beyond the kept ones";
  }
}

TEST(SplitSlices, RefusesToKeepAllOrOne) {
  EXPECT_THROW(split_slices(sphere_stack(-9, 2), 1), InputError);
  EXPECT_THROW(split_slices(sphere_stack(-9, 2), 10), InputError);
}

TEST(LeaveOut, GivesASpheresDroppedCirclesBack) {
  const LeaveOutStudy study = leave_out(sphere_stack(-16, 2), 4, {.max_constraints = 1500});
  EXPECT_EQ(study.kept, 5u);  // z = −16, −8, 0, 8, 16
  EXPECT_EQ(study.dropped, 12u);
  ASSERT_EQ(study.methods.size(), 3u);
  EXPECT_EQ(study.methods[0].method, "isostack");
  EXPECT_LT(study.methods[0].agreement.mean_mm, 0.15);  // a smooth interpolant of 8 mm gaps on a 20 mm sphere
  EXPECT_GT(study.methods[0].agreement.dice, 0.98);
  // Interpolated signed distances of concentric circles are those of circles with the interpolated radius: linear is
  // within the sphere by r(z) minus the chord, in closed form.
  double expected = 0, length = 0;
  for (int i = 0; i < 12; ++i) {
    const double z = std::array{2, 4, 6, 10, 12, 14}[static_cast<std::size_t>(i % 6)];
    const auto radius = [](double at) { return std::sqrt(400 - at * at); };
    const double low = z < 8 ? 0 : 8, share = (z - low) / 8;
    expected += (radius(z) - (1 - share) * radius(low) - share * radius(low + 8)) * radius(z);
    length += radius(z);
  }
  ASSERT_EQ(study.methods[2].method, "linear");
  EXPECT_NEAR(study.methods[2].agreement.mean_mm, expected / length, 0.03);  // marching squares on 1 mm pixels
  ASSERT_EQ(study.methods[1].method, "cubic");
  EXPECT_LT(study.methods[1].agreement.mean_mm, study.methods[2].agreement.mean_mm);
}

TEST(SliceComparison, TellsShiftedSquaresAndOneSidedSlices) {
  const auto square = [](double left) {
    Contour contour;
    contour.points_mm = {{left, 2.5}, {left + 10, 2.5}, {left + 10, 12.5}, {left, 12.5}};
    return std::vector<Contour>{contour};
  };
  const PixelLattice lattice{SlicePose{}, {20, 20}};
  SliceComparison comparison;
  comparison.add(square(2.5), square(4.5), lattice);
  EXPECT_NEAR(comparison.agreement().dice, 0.8, 1e-12);    // 80 of 100 pixels each
  EXPECT_NEAR(comparison.agreement().largest_mm, 2, 0.3);  // points half a pixel apart miss the corners by a quarter
  comparison.add({}, square(4.5), lattice);
  EXPECT_EQ(comparison.agreement().slices, 2u);
  EXPECT_EQ(comparison.agreement().one_sided, 1u);
  EXPECT_NEAR(comparison.agreement().dice, 160.0 / 300, 1e-12);
}

}  // namespace
}  // namespace isostack

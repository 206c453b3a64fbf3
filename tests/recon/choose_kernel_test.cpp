#include "recon/metrics/choose_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isostack {
namespace {

/// A sphere of radius 20 mm cut every 4 mm.
ContourStack sphere_slices() {
  ContourStack stack{.name = "sphere", .slices = {}};
  for (int k = -4; k <= 4; ++k) {
    ContourSlice slice{.name = std::to_string(k), .pose = {}, .size_pixels = {64, 64}, .contours = {}};
    slice.pose.origin_mm = {-32, -32, 4.0 * k};
    const double radius = std::sqrt(400 - 16.0 * k * k);
    Contour circle;
    for (int i = 0; i < 90; ++i) {
      const double angle = 2 * std::numbers::pi * i / 90;
      circle.points_mm.emplace_back(32 + radius * std::cos(angle), 32 + radius * std::sin(angle));
    }
    slice.contours.push_back(circle);
    stack.slices.push_back(slice);
  }
  return stack;
}

TEST(ChooseKernel, TheSmoothestKernelPredictsASphereBest) {
  const std::vector<KernelTrial> trials = try_kernels(sphere_slices(), {.max_constraints = 900});
  ASSERT_EQ(trials.size(), 5u);
  EXPECT_EQ(trials.front().kernel.power, 3);  // r³ bends least, r has cusps at its constraints
  EXPECT_EQ(trials.back().kernel.power, 1);
  for (std::size_t i = 1; i < trials.size(); ++i)
    EXPECT_LE(trials[i - 1].agreement.mean_mm, trials[i].agreement.mean_mm);
  EXPECT_LT(trials.front().agreement.mean_mm, 0.3);  // a third of a pixel, from slices 8 mm apart
}

}  // namespace
}  // namespace isostack

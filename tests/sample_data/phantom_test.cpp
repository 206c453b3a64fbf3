#include "sample_data/phantom.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isostack {
namespace {

SlicePose pose_through_middle() {
  const Eigen::Vector3d middle = phantom_bounds_mm().center();
  SlicePose pose;
  pose.origin_mm = middle - Eigen::Vector3d(63.5, 63.5, 10);
  return pose;
}

/// Calls visit(point, distance) on a 2 mm lattice over the phantom's bounds.
template <class Visit>
void for_each_lattice_point(Visit visit) {
  const Eigen::AlignedBox3d box = phantom_bounds_mm();
  for (double x = box.min().x(); x <= box.max().x(); x += 2)
    for (double y = box.min().y(); y <= box.max().y(); y += 2)
      for (double z = box.min().z(); z <= box.max().z(); z += 2)
        visit(Eigen::Vector3d(x, y, z), phantom_distance_mm({x, y, z}));
}

TEST(Phantom, IsOrganSizedAndWithinItsBounds) {
  Eigen::AlignedBox3d inside;
  for_each_lattice_point([&](const Eigen::Vector3d& point, double distance) {
    if (distance > 0) inside.extend(point);
  });
  EXPECT_GT(inside.sizes().maxCoeff(), 80 - 4);  // the lattice misses up to 2 mm at each end
  EXPECT_LT(inside.sizes().maxCoeff(), 120);
  EXPECT_GT((inside.min() - phantom_bounds_mm().min()).minCoeff(), 2);  // not cut off by the box
  EXPECT_GT((phantom_bounds_mm().max() - inside.max()).minCoeff(), 2);
}

TEST(Phantom, BranchesHaveSpaceBetweenThem) {
  const Eigen::Vector3d fork(-22, 14, 110);
  ASSERT_GT(phantom_distance_mm(fork), 5);
  const Eigen::Vector3d tips[] = {{-56, 16, 154}, {8, 8, 140}, {-19, 42, 144}, {-20, -8, 154}};
  for (const Eigen::Vector3d& tip : tips) {
    EXPECT_GT(phantom_distance_mm(tip), 5);
    for (const Eigen::Vector3d& other : tips) {
      if (other == tip) continue;
      EXPECT_LT(phantom_distance_mm((tip + other) / 2), 0);
    }
  }
}

TEST(Phantom, FieldIsDistanceLikeNearTheSurface) {
  double lowest = 10, highest = 0;
  for_each_lattice_point([&](const Eigen::Vector3d& point, double distance) {
    if (std::abs(distance) > 1) return;
    Eigen::Vector3d gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-4 * Eigen::Vector3d::Unit(axis);
      gradient[axis] = (phantom_distance_mm(point + step) - phantom_distance_mm(point - step)) / 2e-4;
    }
    lowest = std::min(lowest, gradient.norm());
    highest = std::max(highest, gradient.norm());
  });
  EXPECT_LT(highest, 1.05);  // radii taper by at most 0.27 mm per mm: |gradient| <= sqrt(1 + 0.27^2)
  EXPECT_GT(lowest, 0.4);    // where branches fork, a blend averages unit gradients some 120 degrees apart
}

TEST(Phantom, WithoutNoiseTheLevelSeparatesInsideFromOutside) {
  const PhantomImaging imaging{.noise_hu = 0};
  const Slice slice = render_phantom_slice(pose_through_middle(), {128, 128}, imaging);
  int inside_count = 0;
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 128; ++column) {
      const double distance = phantom_distance_mm(slice.pose.pixel_to_world(Eigen::Vector2d(column, row)));
      if (std::abs(distance) < 1e-3) continue;  // on the edge, float rounding decides
      ASSERT_EQ(slice.pixels(row, column) > imaging.level_hu(), distance > 0) << row << ", " << column;
      inside_count += distance > 0;
    }
  EXPECT_GT(inside_count, 500);  // the plane does cut the organ
}

TEST(Phantom, NoiseHasTheStatedStrengthAndMean) {
  const PhantomImaging imaging{.noise_hu = 15, .seed = 7};
  const Slice noisy = render_phantom_slice(pose_through_middle(), {128, 128}, imaging);
  const Slice clean = render_phantom_slice(pose_through_middle(), {128, 128}, {.noise_hu = 0});
  const Image<double> noise = (noisy.pixels - clean.pixels).cast<double>();
  const double mean = noise.mean();
  // 16384 samples: the mean's own deviation is 0.12, that of the deviation 0.08; five of each are allowed.
  EXPECT_NEAR(mean, 0, 0.6);
  EXPECT_NEAR(std::sqrt((noise - mean).square().mean()), 15, 0.4);
}

TEST(Phantom, SeedDecidesThePixels) {
  const auto draw = [](std::uint64_t seed) {
    return render_phantom_slice(pose_through_middle(), {32, 32}, {.seed = seed}).pixels;
  };
  EXPECT_TRUE((draw(3) == draw(3)).all());
  EXPECT_FALSE((draw(3) == draw(4)).all());
}

}  // namespace
}  // namespace isostack

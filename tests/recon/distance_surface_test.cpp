#include "recon/distance/distance_surface.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"

namespace isostack {
namespace {

constexpr double radius_mm = 8;

/// Distances to a ball about `centre_mm` on voxels of 1 mm from 0 to 24 mm, positive inside times `sign`.
Volume<float> ball(const Eigen::Vector3d& centre_mm, float sign = 1) {
  Grid grid;
  grid.size = {25, 25, 25};
  Volume<float> distance_mm(grid);
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i)
        distance_mm.at(i, j, k) = sign * static_cast<float>(radius_mm - (Eigen::Vector3d(i, j, k) - centre_mm).norm());
  return distance_mm;
}

double ball_volume_mm3() { return 4.0 / 3 * std::numbers::pi * std::pow(radius_mm, 3); }

TEST(DistanceSurface, ABallWithinItsVolume) {
  const MeshMeasures found = measure(distance_surface(ball({12, 12, 12})));
  EXPECT_TRUE(found.watertight());
  EXPECT_NEAR(found.volume_mm3, ball_volume_mm3(), 0.02 * ball_volume_mm3());  // linear between voxels of r / 8
}

TEST(DistanceSurface, WhatReachesTheBorderIsClosedThere) {
  const MeshMeasures found = measure(distance_surface(ball({12, 12, 0})));
  EXPECT_TRUE(found.watertight());
  EXPECT_NEAR(found.volume_mm3, ball_volume_mm3() / 2, 0.02 * ball_volume_mm3());
}

TEST(DistanceSurface, AVolumeThatIsPositiveOutsideIsRefused) {
  try {
    distance_surface(ball({12, 12, 12}, -1));
    FAIL() << "a ball inside out was made";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("whole border"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("sign"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace isostack

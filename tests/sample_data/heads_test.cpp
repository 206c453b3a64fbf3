#include "sample_data/heads.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace isostack {
namespace {

TEST(Heads, TheModelledHeadHasAFaceAndEyeSockets) {
  const Body head = modelled_head();
  EXPECT_GT(head.depth_mm({0, 0, 90}), 30);
  EXPECT_GT(head.depth_mm({0, -105, 54}), 0);  // nose
  EXPECT_LT(head.depth_mm({26, -86, 76}), 0);  // eye socket
  EXPECT_EQ(head.depth_mm({26, -60, 76}), head.depth_mm({-26, -60, 76}));
  EXPECT_LT(head.depth_mm({0, 0, 170}), 0);
}

TEST(Heads, TheScanHoldsAirSkinBoneAndBrain) {
  const Volume<float> scan = scanned_head();
  const auto hu_at = [&](const Eigen::Vector3d& place) {
    const Eigen::Vector3d index = scan.grid.index_to_world.inverse() * place;
    return scan.at(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
                   static_cast<int>(std::lround(index.z())));
  };
  constexpr double noise_hu = 25 * 6;  // no sum of twelve dice is farther out
  EXPECT_NEAR(hu_at({0, -130, 150}), -1000, noise_hu);
  EXPECT_NEAR(hu_at({0, 8, 90}), 40, noise_hu);
  EXPECT_NEAR(hu_at({0, 8, 158}), 700, noise_hu);
  EXPECT_NEAR(hu_at({0, -56, 38}), -1000, noise_hu);
  EXPECT_EQ(scan.voxels, scanned_head().voxels);
}

}  // namespace
}  // namespace isostack

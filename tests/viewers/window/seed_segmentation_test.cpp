#include "viewers/window/seed_segmentation.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/viewers/window/ball_images.h"

namespace isostack {
namespace {

using testing_support::ball_images;

double area_mm2(const std::vector<Contour>& contours) {
  double area = 0;
  for (const Contour& contour : contours) area += signed_area_mm2(contour);
  return area;
}

TEST(SeedSegmentation, FindsTheBallAroundTheSeed) {
  Scene scene;
  scene.slices = ball_images(9);
  const SeedSegmentation found = segment_from_seeds(scene, {{{0, 0, 0}, "ball"}}, 4);
  ASSERT_EQ(found.organs.size(), 1U);
  EXPECT_EQ(found.organs[0].name, "ball");
  ASSERT_EQ(found.organs[0].slices.size(), 9U);
  // A disc of radius 10 mm. What is like the seed ends 2.5 standard deviations (22) below 100, which on the edge two
  // pixels wide is half a pixel inside its middle: 31 mm².
  EXPECT_NEAR(area_mm2(found.organs[0].slices[4].contours), std::numbers::pi * 100 - 31, 16);
}

TEST(SeedSegmentation, RecordsTheEvolutionOfOneSlice) {
  Scene scene;
  scene.slices = ball_images(9);
  const SeedSegmentation found = segment_from_seeds(scene, {{{0, 0, 0}, "ball"}}, 4);
  EXPECT_EQ(found.replay.slice, 4U);
  ASSERT_GE(found.replay.states.size(), 2U);
  EXPECT_EQ(found.replay.states.front().time_mm, 0);
  for (std::size_t i = 1; i < found.replay.states.size(); ++i)
    EXPECT_GT(found.replay.states[i].time_mm, found.replay.states[i - 1].time_mm);
  EXPECT_NEAR(area_mm2(found.replay.states.back().contours), area_mm2(found.organs[0].slices[4].contours), 1e-3)
      << "it ends where the segmentation does";
}

TEST(SeedSegmentation, NeedsImages) { EXPECT_THROW(segment_from_seeds({}, {{{0, 0, 0}, "ball"}}, 0), InputError); }

}  // namespace
}  // namespace isostack

// Pictures of a sequence: one frame for all, surfaces that let others show through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/analytic_meshes.h"
#include "viewers/screenshot.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;

class Sequence : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no DISPLAY: run the tests under xvfb-run";
  }
  /// Number of pixels that are not the white ground.
  static int inked(const Picture& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
      count += picture.rgb[i] < 250 || picture.rgb[i + 1] < 250 || picture.rgb[i + 2] < 250;
    return count;
  }
  static TriangleMesh ball(double radius_mm) { return sphere_mesh({5, 6, 7}, radius_mm, 48, 24); }
};

TEST_F(Sequence, FramedOnTheSamePointsBodiesKeepTheirScale) {
  ScreenshotOptions options{.width_pixels = 200, .height_pixels = 200, .look = {.marks = false}};
  options.look.framed_points_mm = ball(40).vertices_mm;
  const int large = inked(draw_picture({.surfaces = {{.mesh = ball(40)}}}, options));
  const int small = inked(draw_picture({.surfaces = {{.mesh = ball(20)}}}, options));
  EXPECT_NEAR(small, large / 4.0, 0.02 * large);  // a pixel of the rim
  options.look.framed_points_mm.clear();
  EXPECT_NEAR(inked(draw_picture({.surfaces = {{.mesh = ball(20)}}}, options)), large, 0.02 * large);
}

TEST_F(Sequence, MarksCanBeLeftOut) {
  ScreenshotOptions options{.width_pixels = 200, .height_pixels = 200};
  const int with_marks = inked(draw_picture({.surfaces = {{.mesh = ball(40)}}}, options));
  options.look.marks = false;
  EXPECT_LT(inked(draw_picture({.surfaces = {{.mesh = ball(40)}}}, options)), with_marks - 100);
}

TEST_F(Sequence, WhatIsInsideShowsThroughATranslucentSurface) {
  Scene nested{.surfaces = {{.mesh = ball(40)}, {.mesh = ball(15)}}};
  ScreenshotOptions options{.width_pixels = 200, .height_pixels = 200, .look = {.marks = false}};
  const auto middle = [&](const Scene& scene) {
    const Picture picture = draw_picture(scene, options);
    return Eigen::Vector3i(picture.rgb[3 * (100 * 200 + 100)], picture.rgb[3 * (100 * 200 + 100) + 1],
                           picture.rgb[3 * (100 * 200 + 100) + 2]);
  };
  Scene alone{.surfaces = {{.mesh = ball(40)}}};
  EXPECT_EQ(middle(nested), middle(alone));  // solid: nothing of the inner ball
  for (Scene* scene : {&nested, &alone}) scene->surfaces[0].opacity = 0.4;
  EXPECT_GT((middle(nested) - middle(alone)).cwiseAbs().maxCoeff(), 20);  // another hue
}

}  // namespace
}  // namespace isostack

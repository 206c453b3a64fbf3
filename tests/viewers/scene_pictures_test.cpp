// Pictures beyond a single screenshot, looked at by their pixels.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "viewers/contradiction_picture.h"
#include "viewers/montage.h"
#include "viewers/screenshot.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;

class ScenePictures : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no DISPLAY: run the tests under xvfb-run";
  }
};

using Pixel = std::array<int, 3>;

Pixel pixel_at(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.rgb[static_cast<std::size_t>(3 * (y * picture.width_pixels + x))];
  return {p[0], p[1], p[2]};
}

int count(const Picture& picture, const std::function<bool(const Pixel&)>& is_wanted) {
  int found = 0;
  for (int y = 0; y < picture.height_pixels; ++y)
    for (int x = 0; x < picture.width_pixels; ++x) found += is_wanted(pixel_at(picture, x, y));
  return found;
}

bool is_like(const Pixel& pixel, const Pixel& colour, int tolerance) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(pixel[c] - colour[c]) > tolerance) return false;
  return true;
}

Contour circle(const Eigen::Vector2d& centre_mm, double radius_mm) {
  Contour contour;
  for (int i = 0; i < 180; ++i)
    contour.points_mm.push_back(centre_mm + radius_mm * Eigen::Vector2d(std::cos(i * std::numbers::pi / 90),
                                                                        std::sin(i * std::numbers::pi / 90)));
  return contour;
}

TEST_F(ScenePictures, ColourBarShowsTheRangeFromBottomToTop) {
  Scene scene{.surfaces = {{.mesh = sphere_mesh({0, 0, 0}, 20, 48, 24)}}};
  scene.surfaces[0].values = VertexValues{.label = "distance, mm",
                                          .values = std::vector<double>(scene.surfaces[0].mesh.vertices_mm.size(), 1.0),
                                          .range = {.low = 0, .high = 2}};
  const Picture picture = draw_picture(scene, {.width_pixels = 400, .height_pixels = 300});
  // The bar is 0.155 heights from the right, 0.030 wide, and 0.52 high about the middle.
  const int x = 400 - 46 + 4;
  const auto colour = [](const Color& c) { return Pixel{c.red, c.green, c.blue}; };
  const ColourRange range = scene.surfaces[0].values->range;
  EXPECT_TRUE(is_like(pixel_at(picture, x, 225), colour(colour_of(0.04, range)), 12));
  EXPECT_TRUE(is_like(pixel_at(picture, x, 150), colour(colour_of(1, range)), 12));
  EXPECT_TRUE(is_like(pixel_at(picture, x, 76), colour(colour_of(1.96, range)), 12));
  // The ball is left of the bar, and has the hue of the middle of the range: green, with much of its blue.
  EXPECT_GT(count(picture, [](const Pixel& p) { return p[1] > p[0] + 40 && p[2] > p[0] + 30; }), 5000);
  scene.surfaces[0].visible = false;
  scene.contours = {
      {.stack = {.name = "ring", .slices = {{.name = "", .pose = {}, .contours = {circle({0, 0}, 20)}}}}}};
  const Picture without = draw_picture(scene, {.width_pixels = 400, .height_pixels = 300});
  EXPECT_TRUE(is_like(pixel_at(without, x, 150), {255, 255, 255}, 2));
}

TEST_F(ScenePictures, HiddenItemsAreNotDrawnAndMarksAreInFrontOfAll) {
  Scene scene{.surfaces = {{.mesh = sphere_mesh({0, 0, 0}, 20, 48, 24)}},
              .marks = {{.from_mm = {-5, 0, 0}, .to_mm = {5, 0, 0}, .text = "10 mm"}}};
  const auto is_mark = [](const Pixel& p) { return p[0] > 150 && p[1] < 90 && p[2] > 70; };
  const ScreenshotOptions options{.width_pixels = 300, .height_pixels = 300, .look = {.marks = false}};
  EXPECT_GT(count(draw_picture(scene, options), is_mark),
            150);  // a line 60 pixels long and its text, within the ball and yet seen
  scene.marks[0].visible = false;
  EXPECT_EQ(count(draw_picture(scene, options), is_mark), 0);
}

TEST_F(ScenePictures, GreyWindowChoosesWhatIsBlackAndWhite) {
  Scene scene{.slices = {{.image = {.name = "flat", .pose = {}, .pixels = Image<float>::Constant(20, 20, 50)}}}};
  ScreenshotOptions options{
      .width_pixels = 100, .height_pixels = 100, .look = {.view_from = {0, 0, -1}, .marks = false}};
  options.look.grey = grey_window_from(200, 100);
  EXPECT_TRUE(is_like(pixel_at(draw_picture(scene, options), 50, 50), {64, 64, 64}, 2));
  options.look.grey = grey_window_from(100, 0);
  EXPECT_TRUE(is_like(pixel_at(draw_picture(scene, options), 50, 50), {255, 255, 255}, 2));
}

TEST_F(ScenePictures, ATurntableTurnsAtOneScaleAndComesRound) {
  // A ball at the patient's left of a larger one: seen from the front at the right, from behind at the left.
  Scene scene{.surfaces = {{.mesh = sphere_mesh({0, 0, 0}, 20, 48, 24)}, {.mesh = sphere_mesh({60, 0, 0}, 8, 48, 24)}}};
  const ScreenshotOptions options{
      .width_pixels = 240, .height_pixels = 120, .look = {.view_from = {0, -1, 0}, .marks = false}};
  const std::vector<Picture> turn = draw_turntable(scene, 4, options);
  ASSERT_EQ(turn.size(), 4U);
  const auto orange_x = [](const Picture& picture) {  // the second surface's colour
    double sum = 0, weight = 0;
    for (int y = 0; y < picture.height_pixels; ++y)
      for (int x = 0; x < picture.width_pixels; ++x) {
        const Pixel p = pixel_at(picture, x, y);
        if (p[0] > p[2] + 30) sum += x, weight += 1;
      }
    return weight > 0 ? sum / weight : -1;
  };
  EXPECT_GT(orange_x(turn[0]), 150);
  EXPECT_LT(orange_x(turn[2]), 90);
  const auto blue = [](const Pixel& p) { return p[2] > p[0] + 30; };
  EXPECT_NEAR(count(turn[0], blue), count(turn[2], blue), 0.05 * count(turn[0], blue));
  EXPECT_THROW(draw_turntable(scene, 1, options), InputError);
}

/// Slices with a square at their upper left, one brighter than the next, and a contour round it.
Scene slices_with_squares(int slices) {
  Scene scene;
  ContourStack squares{.name = "square", .slices = {}};
  for (int k = 0; k < slices; ++k) {
    Slice slice{.name = "", .pose = {}, .pixels = Image<float>::Zero(40, 40)};
    slice.pose.origin_mm.z() = 3 * k;
    slice.pixels.block(4, 4, 12, 12).setConstant(100);
    ContourSlice drawn{.name = "", .pose = slice.pose, .size_pixels = {40, 40}, .contours = {circle({10, 10}, 8)}};
    scene.slices.push_back({.image = slice, .visible = false});
    squares.slices.push_back(drawn);
  }
  scene.contours = {{.stack = squares}};
  return scene;
}

TEST_F(ScenePictures, AMontageHasEverySliceUprightWithItsContour) {
  const Picture sheet = draw_montage(slices_with_squares(6), {.width_pixels = 600, .columns = 3});
  const auto is_white_square = [](const Pixel& p) { return p[0] == 255 && p[1] == 255 && p[2] == 255; };
  const auto is_contour = [](const Pixel& p) { return p[0] > p[2] + 100; };
  EXPECT_NEAR(sheet.width_pixels, 600, 60);
  EXPECT_GT(count(sheet, is_contour), 6 * 150);  // a circle of 16 mm in 40 mm of 200 pixels is 250 pixels round
  // Within each tile the square is at the upper left: rows run down and columns to the right.
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) {
      const int left = 8 + column * 208, top = 8 + row * (200 + 36 + 8);
      EXPECT_TRUE(is_white_square(pixel_at(sheet, left + 50, top + 50))) << row << ", " << column;
      EXPECT_LT(pixel_at(sheet, left + 150, top + 150)[0], 10) << row << ", " << column;
    }
  EXPECT_THROW(draw_montage({.surfaces = {{.mesh = sphere_mesh({0, 0, 0}, 20, 48, 24)}}}), InputError);
}

/// A disc in an axial slice and, crossing it, in a coronal one that says the organ is 3 mm farther left.
Scene contradicting_scene() {
  ContourSlice axial{.name = "axial", .pose = {}, .size_pixels = {100, 100}, .contours = {circle({50, 50}, 20)}};
  ContourSlice coronal{.name = "coronal", .pose = {}, .size_pixels = {100, 100}, .contours = {circle({53, 50}, 20)}};
  coronal.pose.origin_mm = {0, 50, 50};
  coronal.pose.y_axis = {0, 0, -1};
  return {.contours = {{.stack = {.name = "disc", .slices = {axial, coronal}}}}};
}

TEST_F(ScenePictures, TheContradictionIsMarkedWhereItIs) {
  const Scene scene = contradicting_scene();
  const std::optional<ContradictingPair> worst = worst_pair(scene);
  ASSERT_TRUE(worst);
  // On the common line the discs reach from 30 to 70 and from 33 to 73.
  EXPECT_NEAR(worst->pair.largest_mismatch_mm, 3, 0.02);  // polygons of 180 corners
  ASSERT_EQ(worst->pair.places.size(), 2U);
  EXPECT_NEAR(worst->pair.places[0].middle_mm().x() + worst->pair.places[1].middle_mm().x(), 31.5 + 71.5, 0.05);
  const Picture picture = draw_contradiction(scene, *worst, {.width_pixels = 600, .height_pixels = 400});
  const auto in_part = [&](int left, int right, int top, int bottom, const auto& is_wanted) {
    int found = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) found += is_wanted(pixel_at(picture, x, y));
    return found;
  };
  const auto is_mark = [](const Pixel& p) { return p[0] > 140 && p[1] < 90 && p[2] > 70; };
  const auto is_orange = [](const Pixel& p) { return is_like(p, {230, 85, 13}, 60); };
  const auto is_blue = [](const Pixel& p) { return is_like(p, {33, 113, 205}, 60); };
  EXPECT_GT(in_part(0, 360, 0, 400, is_mark), 200);
  for (const int top : {0, 200}) {
    EXPECT_GT(in_part(360, 480, top, top + 200, is_mark), 20) << "the left end in the part at " << top;
    EXPECT_GT(in_part(480, 600, top, top + 200, is_mark), 20) << "the right end in the part at " << top;
  }
  EXPECT_GT(in_part(360, 600, 0, 200, is_orange), in_part(360, 600, 0, 200, is_blue));
  EXPECT_GT(in_part(360, 600, 200, 400, is_blue), in_part(360, 600, 200, 400, is_orange));
}

TEST(WorstPair, IsNoneWhereSlicesAgree) {
  Scene scene = contradicting_scene();
  scene.contours[0].stack.slices[1].contours = {circle({50, 50}, 20)};
  EXPECT_FALSE(worst_pair(scene));
}

}  // namespace
}  // namespace isostack

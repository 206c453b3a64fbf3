#include "viewers/figure_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "viewers/contact_sheet.h"
#include "viewers/picture_text.h"

namespace isostack {
namespace {

Contour circle(double radius_mm, bool is_hole, int points = 720) {
  Contour contour;
  contour.depth = is_hole ? 1 : 0;
  for (int i = 0; i < points; ++i) {
    const double angle = (is_hole ? -2 : 2) * std::numbers::pi * i / points;
    contour.points_mm.emplace_back(30 + radius_mm * std::cos(angle), 20 + radius_mm * std::sin(angle));
  }
  return contour;
}

/// How much of the picture is ink, in pixels; the ink is black on white.
double ink(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) sum += 1 - picture.rgb[i] / 255.0;
  return sum;
}

constexpr FigureLook black_on_white = {.ground = {255, 255, 255}, .fill = {0, 0, 0}};

TEST(FigurePicture, InkIsTheFiguresArea) {
  const std::vector<Contour> ring = {circle(15, false), circle(7.3, true)};
  const PictureFrame frame = frame_round({ring}, 100);
  const Picture picture = draw_figure(ring, frame, black_on_white);
  EXPECT_EQ(std::max(picture.width_pixels, picture.height_pixels), 100);
  const double area_mm2 = std::numbers::pi * (15 * 15 - 7.3 * 7.3);
  // Grey is rounded to 1/255 in some 400 pixels of the edge; lines are 1/16 pixel apart.
  EXPECT_NEAR(ink(picture) / (frame.pixels_per_mm * frame.pixels_per_mm), area_mm2, 1e-3 * area_mm2);
}

TEST(FigurePicture, YGrowsDownAndXToTheRight) {
  Contour corner;  // in the square from (0, 0) to (10, 10), the part with small x and y
  corner.points_mm = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const PictureFrame frame{.box_mm = {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)}, .pixels_per_mm = 2};
  const Picture picture = draw_figure({corner}, frame, black_on_white);
  EXPECT_EQ(picture.rgb[0], 0);                // top left
  EXPECT_EQ(picture.rgb[3 * 19], 255);         // top right
  EXPECT_EQ(picture.rgb[3 * (19 * 20)], 255);  // bottom left
  EXPECT_NEAR(ink(picture), 64, 1e-9);         // edges lie between pixels: nothing is grey
}

TEST(FigurePicture, IsCutOffAtTheFrameAndEmptyWithoutContours) {
  const PictureFrame frame{.box_mm = {Eigen::Vector2d(28, 18), Eigen::Vector2d(32, 22)}, .pixels_per_mm = 5};
  EXPECT_NEAR(ink(draw_figure({circle(15, false)}, frame, black_on_white)), 400, 1e-9);
  EXPECT_EQ(ink(draw_figure({}, frame, black_on_white)), 0);
  EXPECT_THROW(frame_round({{}, {}}, 100), InputError);
  EXPECT_THROW(frame_round({{circle(3, false)}}, 4), InputError);
}

TEST(ContactSheet, HoldsEveryPictureAndItsCaption) {
  const PictureFrame frame = frame_round({{circle(15, false)}}, 90);
  const Picture disc = draw_figure({circle(15, false)}, frame, black_on_white);
  std::vector<CaptionedPicture> pictures(11, {disc, ""});
  const double without_captions = ink(contact_sheet(pictures));
  EXPECT_NEAR(without_captions, 11 * ink(disc), 1e-6);
  for (CaptionedPicture& each : pictures) each.caption = "t = 0.5";
  const Picture sheet = contact_sheet(pictures);
  EXPECT_GT(ink(sheet), without_captions + 11 * 20);     // a caption of seven characters has more than 20 pixels of ink
  EXPECT_GT(sheet.width_pixels, 6 * disc.width_pixels);  // two rows, of six and five
  EXPECT_LT(sheet.width_pixels, 7 * disc.width_pixels);
  EXPECT_THROW(contact_sheet({}), InputError);
  EXPECT_THROW(contact_sheet({{disc, ""}, {draw_figure({}, frame_round({{circle(1, false)}}, 50)), ""}}), InputError);
}

TEST(PictureText, IsDrawnWhereAskedAndCutOffAtTheBorder) {
  Picture picture{.width_pixels = 60, .height_pixels = 40, .rgb = std::vector<std::uint8_t>(60 * 40 * 3, 255)};
  draw_text("0.25", 30, 20, {.height_pixels = 14, .ink = {0, 0, 0}}, picture);
  double x = 0, y = 0;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 60; ++column) {
      const double dark = 1 - picture.rgb[static_cast<std::size_t>(3 * (60 * row + column))] / 255.0;
      x += dark * (column + 0.5), y += dark * (row + 0.5);
    }
  ASSERT_GT(ink(picture), 20);
  EXPECT_NEAR(x / ink(picture), 30, 3);  // digits differ in their weight
  EXPECT_NEAR(y / ink(picture), 20, 3);
  draw_text("a long line of text that does not fit", 0, 39, {}, picture);  // must not write beyond the picture
}

}  // namespace
}  // namespace isostack

#include "viewers/screenshot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "recon/geometry/errors.h"
#include "viewers/palette.h"

namespace isostack {
namespace {

constexpr double radius_mm = 50;

/// A globe of longitudes and latitudes, outwards, with exact normals left out for the renderer to find.
TriangleMesh sphere_mesh(const Eigen::Vector3d& centre_mm) {
  constexpr int meridians = 64, parallels = 32;
  TriangleMesh mesh;
  for (int j = 0; j <= parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      const double longitude = 2 * std::numbers::pi * i / meridians, colatitude = std::numbers::pi * j / parallels;
      mesh.vertices_mm.push_back(centre_mm + radius_mm * Eigen::Vector3d(std::sin(colatitude) * std::cos(longitude),
                                                                         std::sin(colatitude) * std::sin(longitude),
                                                                         std::cos(colatitude)));
    }
  for (int j = 0; j < parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      const int a = j * meridians + i, b = j * meridians + (i + 1) % meridians;
      mesh.triangles.emplace_back(a, a + meridians, b);
      mesh.triangles.emplace_back(b, a + meridians, b + meridians);
    }
  return mesh;
}

ContourStack sphere_contours(const Eigen::Vector3d& centre_mm) {
  ContourStack stack;
  for (double z = -45; z <= 45; z += 10) {
    ContourSlice slice;
    slice.pose.origin_mm = centre_mm + Eigen::Vector3d(0, 0, z);
    Contour circle;
    for (int i = 0; i < 100; ++i) {
      const double angle = 2 * std::numbers::pi * i / 100;
      circle.points_mm.push_back(std::sqrt(radius_mm * radius_mm - z * z) *
                                 Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    slice.contours.push_back(circle);
    stack.slices.push_back(slice);
  }
  return stack;
}

/// A plane 20 pixels wide: dark towards patient right, bright towards left.
Slice two_tone_slice() {
  Slice slice{.name = "two-tone", .pose = {}, .pixels = Image<float>::Constant(20, 20, -50)};
  slice.pixels.rightCols(10).setConstant(100);
  return slice;
}

constexpr int width = 400, height = 300;

/// RGB in [0, 1] of the pixel at column x, row y from the top.
Eigen::Vector3d colour_at(const Picture& picture, int x, int y) {
  const std::uint8_t* pixel = &picture.rgb[static_cast<std::size_t>(3 * (y * picture.width_pixels + x))];
  return Eigen::Vector3d(pixel[0], pixel[1], pixel[2]) / 255;
}

Picture draw(const Scene& scene, ScreenshotOptions options = {}) {
  options.width_pixels = width;
  options.height_pixels = height;
  return draw_picture(scene, options);
}

class Screenshot : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no DISPLAY: run the tests under xvfb-run";
  }

  const Eigen::Vector3d white_ = {1, 1, 1};
  const Eigen::Vector3d far_away_mm_ = {300, -200, 1000};  // framing must follow the scene
};

TEST_F(Screenshot, IsWrittenAsPngOfTheAskedSize) {
  const std::filesystem::path png = std::filesystem::path(testing::TempDir()) / "isostack_screenshot.png";
  save_screenshot({.title = "Sphere", .surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}}, png,
                  {.width_pixels = 400, .height_pixels = 300});
  std::ifstream file(png, std::ios::binary);
  std::string head(24, '\0');
  file.read(head.data(), 24);
  EXPECT_EQ(head.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(head.substr(16, 8), std::string("\0\0\x01\x90\0\0\x01\x2c", 8));  // 400 and 300, big-endian
  std::filesystem::remove(png);
}

TEST_F(Screenshot, HasAWhiteGroundAroundACentredSurface) {
  const Picture picture = draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}});
  ASSERT_EQ(picture.rgb.size(), 3U * width * height);
  for (const int y : {0, 150})
    for (const int x : {0, 399}) EXPECT_EQ(colour_at(picture, x, y), white_) << x << ", " << y;
  EXPECT_GT((colour_at(picture, 200, 150) - white_).norm(), 0.1);
}

TEST_F(Screenshot, SphereFillsFourFifthsOfTheHeight) {
  const Picture picture = draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}});
  int covered = 0;
  for (int y = 0; y < height; ++y) covered += colour_at(picture, 200, y) != white_;
  EXPECT_NEAR(covered, 0.8 * height, 4);  // blurred edges: a pixel or two at either end
}

TEST_F(Screenshot, SurfaceIsShaded) {
  const Picture picture = draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}});
  double darkest = 1, brightest = 0;
  for (int y = 60; y < 240; ++y) {
    darkest = std::min(darkest, colour_at(picture, 200, y).mean());
    brightest = std::max(brightest, colour_at(picture, 200, y).mean());
  }
  EXPECT_GT(brightest - darkest, 0.15);  // flat colour would give 0
}

TEST_F(Screenshot, ContoursLieVisiblyOnTheSurface) {
  const auto contour_pixels = [](const Picture& picture) {
    const Eigen::Vector3d surface = organ_colours(0).surface, contour = organ_colours(0).contour;
    int count = 0;  // the surface is blue, its contours are red, whatever the light
    for (int y = 30; y < 270; ++y)
      for (int x = 80; x < 320; ++x) count += colour_at(picture, x, y).x() > colour_at(picture, x, y).z() + 0.15;
    EXPECT_GT(surface.z(), surface.x());
    EXPECT_GT(contour.x(), contour.z());
    return count;
  };
  EXPECT_EQ(contour_pixels(draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}})), 0);
  // Ten circles; the visible half of each is about as long as it is wide, 60 to 240 pixels.
  EXPECT_GT(contour_pixels(draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}},
                                 .contours = {{.stack = sphere_contours(far_away_mm_)}}})),
            600);
}

TEST_F(Screenshot, ContoursAloneAreDrawn) {
  const Picture picture = draw({.contours = {{.stack = sphere_contours(far_away_mm_)}}});
  int ink = 0;
  for (int y = 30; y < 270; ++y)
    for (int x = 80; x < 320; ++x) ink += colour_at(picture, x, y).z() < 0.6;
  EXPECT_GT(ink, 600);
}

TEST_F(Screenshot, SeenFromTheFrontThePatientsLeftIsAtTheRight) {
  Slice slice = two_tone_slice();
  slice.pose.y_axis = {0, 0, -1};  // a coronal slice
  const Picture picture = draw({.slices = {{.image = slice}}}, {.look = {.view_from = {0, -1, 0}}});
  EXPECT_LT(colour_at(picture, 150, 150).mean(), 0.05);  // the 1st and 99th percentile are black and white
  EXPECT_GT(colour_at(picture, 250, 150).mean(), 0.95);
}

TEST_F(Screenshot, SeenFromBelowAnteriorIsUp) {
  Slice slice = two_tone_slice();
  slice.pixels.topRows(10).setConstant(100);  // rows grow towards posterior: the anterior half is bright
  slice.pixels.bottomRows(10).setConstant(-50);
  const Picture picture = draw({.slices = {{.image = slice}}}, {.look = {.view_from = {0, 0, -1}}});
  EXPECT_GT(colour_at(picture, 200, 90).mean(), 0.95);
  EXPECT_LT(colour_at(picture, 200, 210).mean(), 0.05);
}

TEST_F(Screenshot, DarkGroundIsDark) {
  const Picture picture = draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}}, {.look = {.dark = true}});
  EXPECT_LT(colour_at(picture, 0, 0).maxCoeff(), 0.2);
}

TEST_F(Screenshot, SaysNothingOnItsOwn) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  draw({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}, .contours = {{.stack = sphere_contours(far_away_mm_)}}});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(Screenshot, MissingFolderIsAnInputErrorNamingIt) {
  const auto png = std::filesystem::path(testing::TempDir()) / "isostack_no_such_folder" / "a.png";
  try {
    save_screenshot({.surfaces = {{.mesh = sphere_mesh(far_away_mm_)}}}, png);
    FAIL() << "wrote into a folder that does not exist";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("isostack_no_such_folder"), std::string::npos);
  }
}

/// DISPLAY as told while it lives.
class DisplayVariable {
 public:
  explicit DisplayVariable(const char* value) {
    if (const char* before = std::getenv("DISPLAY")) before_ = before;
    value ? setenv("DISPLAY", value, 1) : unsetenv("DISPLAY");
  }
  ~DisplayVariable() { before_ ? setenv("DISPLAY", before_->c_str(), 1) : unsetenv("DISPLAY"); }

 private:
  std::optional<std::string> before_;
};

TEST(ScreenshotWithoutDisplay, IsAnInputErrorWithARemedy) {
  const std::filesystem::path png = std::filesystem::path(testing::TempDir()) / "isostack_no_display.png";
  for (const char* display : {static_cast<const char*>(nullptr), ":4711"}) {
    const DisplayVariable variable(display);
    try {
      save_screenshot({.surfaces = {{.mesh = sphere_mesh({0, 0, 0})}}}, png);
      FAIL() << "drew without a display";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("xvfb-run"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(png));
  }
}

TEST(ScreenshotOfNothing, IsAnInputError) {
  EXPECT_THROW(save_screenshot({}, "unused.png"), InputError);
  EXPECT_THROW(save_screenshot({.contours = {{.stack = {"empty", {ContourSlice{}}}}}}, "unused.png"), InputError);
}

TEST(ScreenshotOfBrokenInput, IsAnInputError) {
  TriangleMesh mesh = sphere_mesh({0, 0, 0});
  mesh.triangles.emplace_back(0, 1, 1'000'000);
  EXPECT_THROW(save_screenshot({.surfaces = {{.mesh = mesh}}}, "unused.png"), InputError);
  mesh = sphere_mesh({0, 0, 0});
  mesh.vertices_mm[5].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(save_screenshot({.surfaces = {{.mesh = mesh}}}, "unused.png"), InputError);
  EXPECT_THROW(save_screenshot({.surfaces = {{.mesh = sphere_mesh({0, 0, 0})}}}, "unused.png", {.width_pixels = 0}),
               InputError);
}

}  // namespace
}  // namespace isostack

// Colours of values, grey windows, directions of the camera: what needs no display.
#include <gtest/gtest.h>

#include <cmath>

#include "recon/geometry/errors.h"
#include "viewers/camera_presets.h"
#include "viewers/colour_map.h"
#include "viewers/grey_window.h"

namespace isostack {
namespace {

double lightness(const Color& c) { return 0.3 * c.red + 0.59 * c.green + 0.11 * c.blue; }

TEST(ColourMap, SequentialGrowsLighterAllTheWay) {
  const ColourRange range{.low = 2, .high = 4};
  for (double value = 2; value < 3.95; value += 0.05)
    EXPECT_LT(lightness(colour_of(value, range)), lightness(colour_of(value + 0.05, range)) + 1) << value;
  EXPECT_EQ(colour_of(-100, range), colour_of(2, range));
  EXPECT_EQ(colour_of(100, range), colour_of(4, range));
}

TEST(ColourMap, DivergingIsLightestAndGreyAtZeroBlueBelowRedAbove) {
  const ColourRange range{.low = -3, .high = 3, .map = ColourMap::diverging};
  const Color zero = colour_of(0, range), below = colour_of(-3, range), above = colour_of(3, range);
  EXPECT_EQ(zero.red, zero.blue);
  EXPECT_GT(below.blue, below.red + 100);
  EXPECT_GT(above.red, above.blue + 100);
  EXPECT_GT(lightness(zero), std::max(lightness(below), lightness(above)) + 50);
}

TEST(ColourMap, WhatIsNoNumberIsGrey) {
  const Color unknown = colour_of(NAN, {});
  EXPECT_EQ(unknown.red, unknown.green);
  EXPECT_EQ(unknown.green, unknown.blue);
}

TEST(AutomaticRange, IsRoundAndTakesInAllButAFewValues) {
  std::vector<double> values(1000, 0.42);
  values.push_back(1e6);  // one bad vertex must not make all others one colour
  const ColourRange sizes = automatic_range(values);
  EXPECT_EQ(sizes.low, 0);
  EXPECT_DOUBLE_EQ(sizes.high, 0.5);
  values[0] = -0.1;
  const ColourRange both = automatic_range(values);
  EXPECT_EQ(both.map, ColourMap::diverging);
  EXPECT_EQ(both.low, -both.high);
}

TEST(AutomaticGreyWindow, LeavesOutAThousandthAtEitherEnd) {
  Image<float> ramp(100, 101);  // 10,100 values in even steps of 1
  for (Eigen::Index i = 0; i < ramp.size(); ++i) ramp.data()[i] = static_cast<float>(i);
  ramp(0, 0) = NAN;
  const GreyWindow window = automatic_grey_window({&ramp});
  EXPECT_NEAR(window.low, 0.001 * 10'100, 2);
  EXPECT_NEAR(window.high, 0.999 * 10'100, 2);
}

TEST(AutomaticGreyWindow, OfAStackSampledIsThatOfAll) {
  std::vector<Image<float>> images;
  for (int k = 0; k < 24; ++k) {
    images.emplace_back(Image<float>(512, 512));
    for (Eigen::Index i = 0; i < images.back().size(); ++i)
      images.back().data()[i] = static_cast<float>(i % 512 + 10 * k);  // columns differ, and images
  }
  std::vector<const Image<float>*> pointers;
  for (const Image<float>& image : images) pointers.push_back(&image);
  const GreyWindow window = automatic_grey_window(pointers);
  EXPECT_NEAR(window.low, 5, 8);  // 0.1 % of 6.3 million pixels: some of the first columns of the first images
  EXPECT_NEAR(window.high, 741 - 5, 8);
}

TEST(GreyLevels, RunFromBlackToWhiteWithinTheWindow) {
  Image<float> pixels(1, 5);
  pixels << -2000, -160, 40, 240, NAN;
  const Image<std::uint8_t> grey = grey_levels(pixels, grey_window_from(400, 40));
  EXPECT_EQ(grey(0), 0);
  EXPECT_EQ(grey(1), 0);
  EXPECT_NEAR(grey(2), 127.5, 0.5);
  EXPECT_EQ(grey(3), 255);
  EXPECT_EQ(grey(4), 0);
}

TEST(CameraPresets, AreThePatientsDirectionsInLps) {
  EXPECT_EQ(camera_direction("anterior"), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(camera_direction("left"), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(camera_direction("superior"), Eigen::Vector3d(0, 0, 1));
  try {
    camera_direction("sideways");
    FAIL() << "took a name it does not know";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("posterior"), std::string::npos);
  }
}

}  // namespace
}  // namespace isostack

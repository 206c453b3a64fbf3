#include "io/dicom/cielab.h"

#include <gtest/gtest.h>

namespace isostack {
namespace {

TEST(Cielab, KnownColours) {
  // Lab of sRGB's primaries relative to D65 (53.24, 80.09, 67.20 and so on), scaled as DICOM asks; rounding of the
  // published figures is some 10 of 65535.
  const DicomLab red = lab_from_color({255, 0, 0}), white = lab_from_color({255, 255, 255});
  EXPECT_NEAR(red[0], 53.24 * 655.35, 10);
  EXPECT_NEAR(red[1], (80.09 + 128) * 257, 10);
  EXPECT_NEAR(red[2], (67.20 + 128) * 257, 10);
  EXPECT_NEAR(white[0], 65535, 1);
  EXPECT_NEAR(white[1], 128 * 257, 3);
  EXPECT_EQ(lab_from_color({0, 0, 0})[0], 0);
}

TEST(Cielab, EveryColourComesBack) {
  for (int red = 0; red < 256; red += 15)
    for (int green = 0; green < 256; green += 15)
      for (int blue = 0; blue < 256; blue += 15) {
        const Color color{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                          static_cast<std::uint8_t>(blue)};
        EXPECT_EQ(color_from_lab(lab_from_color(color)), color) << red << ' ' << green << ' ' << blue;
      }
}

TEST(Cielab, WhatIsOutsideSrgbIsClipped) {
  EXPECT_EQ(color_from_lab({65535, 65535, 65535}).red, 255);
  EXPECT_EQ(color_from_lab({0, 0, 0}).red, 0);
}

}  // namespace
}  // namespace isostack

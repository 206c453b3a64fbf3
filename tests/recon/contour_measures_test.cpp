#include "recon/metrics/contour_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isostack {
namespace {

constexpr double pi = std::numbers::pi;

Contour circle(double radius_mm, bool is_hole) {
  Contour contour;
  contour.depth = is_hole ? 1 : 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = (is_hole ? -2 : 2) * pi * i / 400;
    contour.points_mm.emplace_back(3 + radius_mm * std::cos(angle), radius_mm * std::sin(angle));
  }
  return contour;
}

TEST(ContourMeasures, OfARingAreInClosedForm) {
  const ContourMeasures ring = measure({circle(20, false), circle(8, true)}, 1.0);
  EXPECT_EQ(ring.components, 1u);
  EXPECT_EQ(ring.holes, 1u);
  EXPECT_NEAR(ring.area_mm2, pi * (400 - 64), 1e-3 * pi * 400);  // 400 chords: 4e-5 of each disc
  EXPECT_NEAR(ring.perimeter_mm, 2 * pi * 28, 0.01);
  // Points on the polygon's chords lie up to 0.0006 mm inside the circle, 2 % of the 0.025 mm by which it bends over a
  // millimetre.
  EXPECT_NEAR(ring.highest_curvature_per_mm, 1.0 / 20, 0.03 / 20);
  EXPECT_NEAR(ring.lowest_curvature_per_mm, -1.0 / 8, 0.03 / 8);
}

TEST(ContourMeasures, ACornerHasTheCurvatureOfTheScale) {
  Contour square;
  square.points_mm = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const ContourMeasures measures = measure({square}, 0.5);
  EXPECT_NEAR(measures.highest_curvature_per_mm, 2 * std::sin(pi / 4) / 0.5, 1e-9);
}

TEST(ContourMeasures, OfNothingAreZero) {
  const ContourMeasures nothing = measure(std::vector<Contour>{}, 1.0);
  EXPECT_EQ(nothing.components, 0u);
  EXPECT_EQ(nothing.area_mm2, 0);
  EXPECT_EQ(nothing.highest_curvature_per_mm, 0);
}

TEST(ContourMeasures, SmallCurvesTakeAQuarterOfTheirLength) {
  const ContourMeasures dot = measure({circle(0.1, false)}, 5.0);
  EXPECT_NEAR(dot.highest_curvature_per_mm, 10, 0.1);  // points a quarter apart still lie on the circle
}

}  // namespace
}  // namespace isostack

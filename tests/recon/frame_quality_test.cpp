#include "recon/metrics/frame_quality.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

constexpr double pi = std::numbers::pi;

TEST(FrameQuality, OfARing) {
  const FrameQuality q = frame_quality(testing_support::o_figure().shape);  // radii 22 and 38 mm
  EXPECT_EQ(q.components, 1u);
  EXPECT_EQ(q.holes, 1u);
  // Chords within 2 µm of the circles.
  EXPECT_NEAR(q.content, pi * (38 * 38 - 22 * 22), 2 * pi * 60 * 0.002);
  EXPECT_NEAR(q.boundary, 2 * pi * (38 + 22), 0.05);
  EXPECT_NEAR(q.highest_curvature, 1.0 / 38, 0.01);  // seen over 2 mm: chords 2 µm deep tilt it by 4 · 0.002 / 1
  EXPECT_NEAR(q.lowest_curvature, -1.0 / 22, 0.01);
  EXPECT_DOUBLE_EQ(q.largest_curvature(), -q.lowest_curvature);
}

TEST(FrameQuality, SeesCornersAtItsScale) {
  ContourSlice square;
  square.contours = {{.points_mm = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}}};
  // A right angle: 2 sin 45° over the scale.
  EXPECT_NEAR(frame_quality(square).highest_curvature, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(frame_quality(square, {.curvature_scale_mm = 2}).highest_curvature, std::sqrt(0.5), 1e-9);
}

TEST(FrameQuality, OfATorus) {
  const FrameQuality q = frame_quality(testing_support::torus_mesh(30, 10, 200, 100));
  EXPECT_EQ(q.components, 1u);
  EXPECT_EQ(q.holes, 1u);
  EXPECT_NEAR(q.content / (2 * pi * pi * 30 * 100), 1, 2e-3);  // facets: 1 − (2π/100)² / 6 − (2π/200)² / 6
  EXPECT_NEAR(q.boundary / (4 * pi * pi * 300), 1, 2e-3);
  // Mean curvature from (1/10 − 1/20) / 2 inside to (1/10 + 1/40) / 2 outside.
  EXPECT_NEAR(q.lowest_curvature, 0.025, 0.001);
  EXPECT_NEAR(q.highest_curvature, 0.0625, 0.001);
}

TEST(FrameQuality, OfNothingIsZero) {
  for (const Shape& nothing : {Shape(ContourSlice{}), Shape(TriangleMesh{})}) {
    const FrameQuality q = frame_quality(nothing);
    EXPECT_EQ(q.components, 0u);
    EXPECT_EQ(q.holes, 0u);
    EXPECT_EQ(q.content, 0);
    EXPECT_EQ(q.largest_curvature(), 0);
  }
}

}  // namespace
}  // namespace isostack

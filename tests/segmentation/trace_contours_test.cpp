#include "segmentation/trace_contours.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::Disc;
using test::sampled;

/// Every pixel centre lies on its side, curves have no repeated point, and depth and direction are those
/// orient_by_nesting would give.
void expect_faithful(const Image<float>& phi, const Eigen::Vector2d& spacing_mm) {
  std::vector<Contour> contours = trace_contours(phi, spacing_mm);
  for (Eigen::Index row = 0; row < phi.rows(); ++row)
    for (Eigen::Index column = 0; column < phi.cols(); ++column) {
      const Eigen::Vector2d centre = Eigen::Vector2d(column, row).cwiseProduct(spacing_mm);
      ASSERT_EQ(is_inside(contours, centre), phi(row, column) >= 0) << "row " << row << " column " << column;
    }
  std::set<std::pair<double, double>> points;
  std::size_t count = 0;
  for (const Contour& contour : contours) {
    EXPECT_GE(contour.points_mm.size(), 4u);
    count += contour.points_mm.size();
    for (const auto& point : contour.points_mm) {
      EXPECT_TRUE(point.allFinite());
      points.emplace(point.x(), point.y());
    }
  }
  EXPECT_EQ(points.size(), count);
  std::vector<Contour> oriented = contours;
  orient_by_nesting(oriented);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    EXPECT_EQ(oriented[i].depth, contours[i].depth);
    EXPECT_EQ(signed_area_mm2(oriented[i]), signed_area_mm2(contours[i]));
  }
}

TEST(TraceContours, EllipseOnAnisotropicPixelsHasItsAreaAndPerimeter) {
  const Eigen::Vector2d spacing_mm(0.5, 0.8);
  const double a = 14, b = 9;
  const auto phi =
      sampled(60, 80, spacing_mm, [&](double x, double y) { return 1 - std::hypot((x - 19.7) / a, (y - 23.2) / b); });
  const auto contours = trace_contours(phi, spacing_mm);
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].depth, 0);
  // Chords of length s cut off s²κ/12 on average: below 0.15 % of the area here.
  EXPECT_NEAR(signed_area_mm2(contours[0]), std::numbers::pi * a * b, 0.002 * std::numbers::pi * a * b);
  for (const auto& p : contours[0].points_mm) EXPECT_NEAR(std::hypot((p.x() - 19.7) / a, (p.y() - 23.2) / b), 1, 0.002);
  expect_faithful(phi, spacing_mm);
}

TEST(TraceContours, LinearFieldGivesExactCrossings) {
  const auto phi = sampled(8, 9, {2, 3}, [](double x, double) { return 7.25 - x; });
  const auto contours = trace_contours(phi, {2, 3});
  ASSERT_EQ(contours.size(), 1u);
  int on_line = 0;
  for (const auto& p : contours[0].points_mm) on_line += std::abs(p.x() - 7.25) < 1e-6;
  EXPECT_EQ(on_line, 8);  // one crossing in each row
}

TEST(TraceContours, AnnulusWithIslandNestsAndOrients) {
  const auto phi = sampled(64, 64, {1, 1}, [](double x, double y) {
    const double r = std::hypot(x - 31.5, y - 31.5);
    return std::max(std::min(25.3 - r, r - 15.2), 6.4 - r);
  });
  const auto contours = trace_contours(phi, {1, 1});
  ASSERT_EQ(contours.size(), 3u);
  for (const Contour& contour : contours) {
    const double radius = std::array{25.3, 15.2, 6.4}[static_cast<std::size_t>(contour.depth)];
    const double area = (contour.depth == 1 ? -1 : 1) * std::numbers::pi * radius * radius;
    EXPECT_NEAR(signed_area_mm2(contour), area, 0.01 * std::abs(area));  // chords, r = 6.4 pixels
  }
  expect_faithful(phi, {1, 1});
}

TEST(TraceContours, SaddleJoinsTheCornersItsBilinearSaddlePointTells) {
  // Saddle value (ac − bd)/(a + c − b − d) of the four middle pixels: with 3 against −1 the diagonal joins.
  Image<float> phi = Image<float>::Constant(4, 4, -1);
  phi(1, 1) = phi(2, 2) = 3;
  EXPECT_EQ(trace_contours(phi, {1, 1}).size(), 1u);
  expect_faithful(phi, {1, 1});
  phi(1, 1) = phi(2, 2) = 0.3f;
  EXPECT_EQ(trace_contours(phi, {1, 1}).size(), 2u);
  expect_faithful(phi, {1, 1});
  // The mirrored diagonal, joined and separate.
  for (const float value : {3.0f, 0.3f}) {
    phi.setConstant(-1);
    phi(1, 2) = phi(2, 1) = value;
    EXPECT_EQ(trace_contours(phi, {1, 1}).size(), value > 1 ? 1u : 2u);
    expect_faithful(phi, {1, 1});
  }
}

TEST(TraceContours, OrganCutByTheImageClosesHalfAPixelOutside) {
  const Image<float> phi = Image<float>::Constant(5, 7, 1);
  const auto contours = trace_contours(phi, {2, 1});
  ASSERT_EQ(contours.size(), 1u);
  // Whole pixels, minus the four triangles of half a pixel's legs at the corners.
  EXPECT_NEAR(signed_area_mm2(contours[0]), (5 * 7 - 4 * 0.125) * 2, 1e-9);
  expect_faithful(phi, {2, 1});
}

TEST(TraceContours, TellsWhetherTheFieldOfViewCutsTheOrgan) {
  for (const double x : {14.0, 4.0}) {
    const auto phi = sampled(30, 30, {1, 1}, Disc{x, 15, 6});
    ContourSlice slice;
    slice.size_pixels = {30, 30};
    slice.contours = trace_contours(phi, {1, 1});
    EXPECT_EQ(touches_border(phi), x < 6);
    EXPECT_EQ(touches_border(slice), x < 6);
  }
}

TEST(TraceContours, ZeroCountsAsInsideWithoutRepeatedPoints) {
  Image<float> phi = Image<float>::Constant(7, 7, -1);
  phi(3, 3) = 0;  // alone
  EXPECT_EQ(trace_contours(phi, {1, 1}).size(), 1u);
  expect_faithful(phi, {1, 1});
  phi.block(2, 2, 3, 3) = 0;  // a plateau
  expect_faithful(phi, {1, 1});
  phi(3, 3) = -1;  // ... with a hole
  EXPECT_EQ(trace_contours(phi, {1, 1}).size(), 2u);
  expect_faithful(phi, {1, 1});
}

TEST(TraceContours, AnyFloatsGiveFaithfulClosedCurves) {
  std::mt19937 random(7);
  const float huge = std::numeric_limits<float>::max(), infinite = std::numeric_limits<float>::infinity();
  const float tiny = std::numeric_limits<float>::denorm_min();
  const std::vector<float> values = {0, -0.0f, 1, -1, 0.5f, -2, tiny, -tiny, huge, -huge, infinite, -infinite};
  for (int trial = 0; trial < 200; ++trial) {
    Image<float> phi(12, 9);
    for (float& value : phi.reshaped()) value = values[random() % values.size()];
    expect_faithful(phi, {0.7, 1.3});
  }
}

TEST(TraceContours, NoiseNestsLikeTheSlowRule) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  Image<float> phi(60, 70);
  for (float& value : phi.reshaped()) value = normal(random);
  EXPECT_GT(trace_contours(phi, {1, 1}).size(), 150u);
  expect_faithful(phi, {1, 1});
}

TEST(TraceContours, NothingInsideGivesNothing) {
  EXPECT_TRUE(trace_contours(Image<float>::Constant(4, 5, -1), {1, 1}).empty());
  EXPECT_TRUE(trace_contours(Image<float>(), {1, 1}).empty());
}

}  // namespace
}  // namespace isostack

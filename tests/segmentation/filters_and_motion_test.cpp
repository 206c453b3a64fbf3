// The parts of a start: filters, levels, offsets, hulls.
#include <gtest/gtest.h>

#include <numbers>

#include "segmentation/convex_hull.h"
#include "segmentation/diffusion.h"
#include "segmentation/offset_motion.h"
#include "segmentation/threshold.h"
#include "segmentation/trace_contours.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::Disc;
using test::sampled;

constexpr double pi = std::numbers::pi;

TEST(Diffusion, TakesNoiseAndKeepsTheEdgeAndTheMean) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 5);
  const auto step = sampled(40, 40, {1, 1}, [&](double x, double) { return (x < 20 ? 0 : 200) + noise(random); });
  const auto smooth = anisotropic_diffusion(step, {1, 1}, {.contrast = 25, .steps = 20});
  EXPECT_NEAR(smooth.mean(), step.mean(), 1e-3);  // fluxes balance; float sums of 1600 pixels
  const auto deviation = [](const Image<float>& image) {
    const auto left = image.leftCols(18);
    return std::sqrt((left - left.mean()).square().mean());
  };
  EXPECT_LT(deviation(smooth), deviation(step) / 3);
  // A Gaussian of the same steps would leave 45 of 200 between the two columns beside the edge; g(200) is 1/65.
  EXPECT_GT((smooth.col(20) - smooth.col(19)).mean(), 170);
}

TEST(Diffusion, WithoutContrastsItIsTheHeatEquation) {
  // A wave far below the contrast decays by exp(-k² t), t = steps · step length; anisotropic pixels.
  const Eigen::Vector2d spacing_mm(1, 2);
  const double k = 2 * pi / 16;
  const auto wave = sampled(8, 64, spacing_mm, [&](double x, double) { return std::cos(k * (x + 0.5)); });
  const auto smooth = anisotropic_diffusion(wave, spacing_mm, {.contrast = 1e4, .steps = 10});
  const double t = 10 * 0.5 / (1 + 0.25);
  EXPECT_NEAR(smooth(4, 0) / wave(4, 0), std::exp(-k * k * t), 0.03);  // explicit steps: (1 − k² dt)^10
}

TEST(Otsu, FindsTheLevelBetweenTwoClasses) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 8);
  const auto image = sampled(64, 64, {1, 1}, [&](double x, double y) {
    return (Disc{30, 30, 15}(x, y) > 0 ? 120 : 20) + noise(random);
  });
  const OtsuClasses classes = otsu_classes({image});
  EXPECT_NEAR(classes.dark_mean, 20, 1);
  EXPECT_NEAR(classes.bright_mean, 120, 1);
  EXPECT_GT(classes.level, 45);
  EXPECT_LT(classes.level, 95);
  EXPECT_TRUE(std::isnan(otsu_classes({Image<float>::Constant(5, 5, 7)}).level));
}

double area_of(const Field<2>& field) {
  return test::total_area_mm2(trace_contours(image_of(field), {field.spacing_mm[0], field.spacing_mm[1]}));
}

TEST(OffsetMotion, GrowsAndShrinksADiscByTheDistance) {
  const Eigen::Vector2d spacing_mm(0.7, 1.1);
  const auto disc = field_of(sampled(70, 110, spacing_mm, Disc{38, 38, 15}), spacing_mm);
  for (const double distance_mm : {-6.0, -1.3, 2.4, 8.0}) {
    const double radius = 15 + distance_mm;
    // Fast marching is right to about 0.05 pixel.
    EXPECT_NEAR(area_of(offset_region(disc, distance_mm, 5)), pi * radius * radius, 2 * pi * radius * 0.06);
  }
}

TEST(OffsetMotion, OpeningCutsABridgeAndClosingAGap) {
  // Two discs of radius 12 joined by a bridge 5 mm wide.
  const auto dumbbell = [](double x, double y) {
    return std::max(
        {Disc{20, 30, 12}(x, y), Disc{60, 30, 12}(x, y), std::min({2.5 - std::abs(y - 30), x - 20, 60 - x})});
  };
  const auto field = field_of(sampled(60, 80, {1, 1}, dumbbell), {1, 1});
  const auto parts = trace_contours(image_of(open_region(field, 4, 5)), {1, 1});
  ASSERT_EQ(parts.size(), 2u);
  for (const Contour& part : parts)
    EXPECT_NEAR(signed_area_mm2(part), pi * 144, 0.04 * pi * 144);  // fillets at the bridge
  EXPECT_EQ(trace_contours(image_of(open_region(field, 2, 5)), {1, 1}).size(), 1u);

  // A slit 3 mm wide through a disc.
  const auto slit = [](double x, double y) { return std::min(Disc{30, 30, 20}(x, y), std::abs(x - 30) - 1.5); };
  const auto closed = close_region(field_of(sampled(60, 60, {1, 1}, slit), {1, 1}), 3, 5);
  EXPECT_EQ(trace_contours(image_of(closed), {1, 1}).size(), 1u);
  EXPECT_NEAR(area_of(closed), pi * 400, 0.02 * pi * 400);  // dents left where the slit leaves the disc
}

TEST(OffsetMotion, WorksInThreeDimensions) {
  Field<3> ball{{40, 40, 20}, {1, 1, 2}, {}};
  ball.values.resize(40 * 40 * 20);
  for (std::size_t node = 0; node < ball.values.size(); ++node) {
    const auto p = ball.position_of(node);
    ball.values[node] = static_cast<float>(10 - std::hypot(p[0] - 20.0, p[1] - 20.0, 2 * p[2] - 20.0));
  }
  const auto grown = offset_region(ball, 4, 3);
  for (std::size_t node = 0; node < grown.values.size(); ++node) {
    const auto p = grown.position_of(node);
    const double expected = 14 - std::hypot(p[0] - 20.0, p[1] - 20.0, 2 * p[2] - 20.0);
    if (std::abs(expected) >= 1) continue;
    EXPECT_NEAR(grown.values[node], expected, 0.15);  // of a pixel of 1 to 2 mm
  }
}

TEST(ConvexHull, OfALetterCIsItsDisc) {
  const auto letter = [](double x, double y) {
    const double r = std::hypot(x - 30, y - 30);
    return std::max(std::min({20 - r, r - 12, std::abs(std::atan2(y - 30, x - 30)) * r - 5.0}), -5.0);
  };
  const auto phi = sampled(60, 60, {1, 1}, letter);
  const auto hull = trace_contours(hull_of_parts(phi, {1, 1}), {1, 1});
  ASSERT_EQ(hull.size(), 1u);
  // The chord over the opening of 10 mm cuts off a segment of 4 mm²; polygons lose a little more.
  EXPECT_NEAR(signed_area_mm2(hull[0]), pi * 400 - 4, 0.005 * pi * 400);
  EXPECT_EQ(convex_hull({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}}).size(), 4u);
}

}  // namespace
}  // namespace isostack

#include "segmentation/level_set.h"

#include <gtest/gtest.h>

#include <numbers>

#include "segmentation/derivatives.h"
#include "segmentation/trace_contours.h"
#include "tests/segmentation/fields.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::field_from;

const Eigen::Vector2d centre(32.2, 31.7);

Field<2> disc_field(double radius, const std::array<double, 2>& spacing_mm = {1, 1}) {
  const std::array<int, 2> size = {static_cast<int>(64 / spacing_mm[0]), static_cast<int>(64 / spacing_mm[1])};
  return field_from<2>(size, spacing_mm, [&](const auto& p) { return radius - (p - centre).norm(); });
}

/// A disc of grey value 100 on 20 whose edge is blurred over about a pixel; 60 lies on the radius.
Field<2> disc_image(double radius, const std::array<double, 2>& spacing_mm = {1, 1}) {
  auto image = disc_field(radius, spacing_mm);
  for (float& value : image.values) value = 60 + 40 * std::tanh(value / 1.3f);
  return image;
}

std::vector<Contour> contours_of(const Field<2>& phi) {
  return trace_contours(image_of(phi), {phi.spacing_mm[0], phi.spacing_mm[1]});
}

double radius_of(const Field<2>& phi) { return std::sqrt(test::total_area_mm2(contours_of(phi)) / std::numbers::pi); }

TEST(LevelSet, CurvatureFlowOfCircleLosesAreaAtTheKnownRate) {
  const double initial = 20, time_mm = 100;
  CurvatureTerm<2> curvature(1);
  LevelSetOptions options;
  options.max_steps = 5000;
  options.max_time_mm = time_mm;
  options.tolerance_pixels = 0;
  const auto result = evolve<2>(disc_field(initial), {&curvature}, options);
  EXPECT_EQ(result.stop, LevelSetStop::max_time);
  EXPECT_DOUBLE_EQ(result.time_mm, time_mm);
  const double expected = initial * initial - 2 * time_mm;
  EXPECT_NEAR(std::pow(radius_of(result.phi), 2), expected, 0.01 * expected);
}

TEST(LevelSet, CurvatureFlowOfBallUsesTheSumOfBothCurvatures) {
  const Eigen::Vector3d middle(12, 12, 12);
  CurvatureTerm<3> curvature(1);
  LevelSetOptions options;
  options.max_steps = 1000;
  options.max_time_mm = 9;
  options.tolerance_pixels = 0;
  const auto result =
      evolve<3>(field_from<3>({25, 25, 25}, {1, 1, 1}, [&](const auto& p) { return 10 - (p - middle).norm(); }),
                {&curvature}, options);
  const double radius = std::sqrt(100 - 4 * 9.0);
  EXPECT_NEAR(result.phi.values[result.phi.node_at({12, 12 + 8, 12})], radius - 8, 0.05);
}

TEST(LevelSet, IsosurfaceTermGrowsTooSmallAndShrinksTooLargeDiscsToTheEdge) {
  for (const auto& spacing_mm : {std::array{1.0, 1.0}, std::array{0.8, 1.3}})
    for (const double initial : {8.0, 22.0}) {
      const double radius = 15;
      IsosurfaceTerm<2> isosurface(disc_image(radius, spacing_mm), 60, 1);
      const auto result = evolve<2>(disc_field(initial, spacing_mm), {&isosurface}, {});
      EXPECT_EQ(result.stop, LevelSetStop::converged);
      const auto distances = test::distances_to({centre.x(), centre.y(), radius}, contours_of(result.phi));
      EXPECT_LT(distances.largest, 0.1 * spacing_mm[1]);  // pixels
    }
}

TEST(LevelSet, CurveLeavesTheFieldOfViewStraight) {
  const auto cut_disc = [](double radius) {
    return field_from<2>({40, 64}, {1, 1}, [=](const auto& p) { return radius - std::hypot(p.x() + 3, p.y() - 31.7); });
  };
  auto image = cut_disc(20);
  for (float& value : image.values) value = std::tanh(value / 1.3f);
  IsosurfaceTerm<2> isosurface(image, 0, 1);
  const auto result = evolve<2>(cut_disc(12), {&isosurface}, {});
  const auto contours = contours_of(result.phi);
  ASSERT_EQ(contours.size(), 1u);
  for (const auto& p : contours[0].points_mm) {
    if (p.x() >= 0) {
      EXPECT_NEAR(std::hypot(p.x() + 3, p.y() - 31.7), 20, 0.1);  // the rest runs along the border
    }
  }
}

TEST(LevelSet, CurvatureShiftsTheEdgeWhereBothTermsBalance) {
  const double radius = 15, weight_mm = 2;
  const auto image = disc_field(radius);  // |∇I| = 1: α is the distance to the edge
  IsosurfaceTerm<2> isosurface(image, 0, 1);
  CurvatureTerm<2> curvature(weight_mm);
  LevelSetOptions options;
  options.max_steps = 500;
  const auto result = evolve<2>(disc_field(18), {&isosurface, &curvature}, options);
  EXPECT_EQ(result.stop, LevelSetStop::converged);
  // g(radius − r) = β/r
  double balance = radius;
  for (int i = 0; i < 50; ++i) {
    const double speed = weight_mm / balance;
    balance = radius - speed / std::sqrt(1 - speed * speed);
  }
  EXPECT_NEAR(radius_of(result.phi), balance, 0.03);  // the stop leaves a few hundredths of a pixel
}

TEST(LevelSet, ConstantSpeedDilatesAndErodesByTime) {
  for (const double speed : {1.0, -1.0}) {
    ConstantTerm<2> propagator(speed);
    LevelSetOptions options;
    options.max_time_mm = 4;
    const auto result = evolve<2>(disc_field(14), {&propagator}, options);
    EXPECT_EQ(result.stop, LevelSetStop::max_time);
    EXPECT_NEAR(radius_of(result.phi), 14 + 4 * speed, 0.1);  // a tenth of a pixel: the scheme is of first order
  }
}

TEST(LevelSet, DilationMergesDiscsAndErosionRemovesSmallOnes) {
  const auto two = field_from<2>({60, 40}, {1, 1}, [](const auto& p) {
    return std::max(8 - (p - Eigen::Vector2d(20, 20)).norm(), 6 - (p - Eigen::Vector2d(39, 20)).norm());
  });
  LevelSetOptions options;
  options.max_time_mm = 4;
  ConstantTerm<2> dilate(1), erode(-1);
  EXPECT_EQ(contours_of(two).size(), 2u);
  EXPECT_EQ(contours_of(evolve<2>(two, {&dilate}, options).phi).size(), 1u);
  options.max_time_mm = 7;
  EXPECT_EQ(contours_of(evolve<2>(two, {&erode}, options).phi).size(), 1u);
}

TEST(LevelSet, ResultIsASignedDistanceAndRunsAreIdentical) {
  IsosurfaceTerm<2> isosurface(disc_image(15), 60, 1);
  const auto result = evolve<2>(disc_field(9), {&isosurface}, {});
  for (std::size_t node = 0; node < result.phi.values.size(); ++node)
    if (std::abs(result.phi.values[node]) < 5) {
      EXPECT_NEAR(derivatives_at(result.phi, node).gradient().norm(), 1, 0.05);
    }
  EXPECT_EQ(evolve<2>(disc_field(9), {&isosurface}, {}).phi.values, result.phi.values);
}

TEST(LevelSet, SaysWhyItStopped) {
  IsosurfaceTerm<2> isosurface(disc_image(15), 60, 1);
  LevelSetOptions options;
  options.max_steps = 3;
  const auto cut_short = evolve<2>(disc_field(8), {&isosurface}, options);
  EXPECT_EQ(cut_short.stop, LevelSetStop::max_steps);
  EXPECT_EQ(cut_short.steps, 3);
  EXPECT_GT(cut_short.rms_change_pixels, options.tolerance_pixels);

  ConstantTerm<2> erode(-1);
  const auto gone = evolve<2>(disc_field(3), {&erode}, {});
  EXPECT_EQ(gone.stop, LevelSetStop::vanished);
  EXPECT_LT(*std::max_element(gone.phi.values.begin(), gone.phi.values.end()), 0);
}

/// A term of the user's own: drives the curve to a given area, whatever the image.
class AreaTerm : public SpeedTerm<2> {
 public:
  explicit AreaTerm(double area_mm2) : area_mm2_(area_mm2) {}
  void prepare(const Field<2>& phi) override {
    const auto inside = std::count_if(phi.values.begin(), phi.values.end(), [](float value) { return value >= 0; });
    speed_ = std::clamp((area_mm2_ - static_cast<double>(inside)) / 50, -1.0, 1.0);
  }
  double propagation(std::size_t) const override { return speed_; }

 private:
  double area_mm2_, speed_ = 0;
};

TEST(LevelSet, UsersCanAddATermThatLooksAtTheWholeField) {
  AreaTerm area(700);
  const auto result = evolve<2>(disc_field(10), {&area}, {});
  EXPECT_NEAR(test::total_area_mm2(contours_of(result.phi)), 700, 20);  // pixels are counted, the outline is ~94 long
}

}  // namespace
}  // namespace isostack

// Segmentation of discs whose place is known, under noise, blur and bias.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "segmentation/edge_term.h"
#include "segmentation/gaussian_filter.h"
#include "segmentation/level_set.h"
#include "segmentation/region_term.h"
#include "segmentation/trace_contours.h"
#include "tests/segmentation/fields.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::field_from;

constexpr double radius = 20, contrast = 80;
const Eigen::Vector2d centre(32.2, 31.7);

struct Phantom {
  double cnr = 0;        ///< contrast over the noise's standard deviation; 0: no noise
  double bias = 0;       ///< share by which the grey values rise from left to right
  double blur_mm = 1.3;  ///< width of the edge
};

Field<2> picture(const Phantom& phantom, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, phantom.cnr > 0 ? contrast / phantom.cnr : 0);
  return field_from<2>({65, 64}, {1, 1}, [&](const auto& p) {
    const double clean = 60 + contrast / 2 * std::tanh((radius - (p - centre).norm()) / phantom.blur_mm);
    return clean * (1 + phantom.bias * (p.x() - centre.x()) / 32) + (phantom.cnr > 0 ? noise(random) : 0);
  });
}

Field<2> filtered(const Field<2>& image, double sigma_mm) {
  return field_of(gaussian_filter_mm(image_of(image), sigma_mm, {1, 1}), {1, 1});
}

Field<2> start(double r) {
  return field_from<2>({65, 64}, {1, 1}, [=](const auto& p) { return r - (p - centre).norm(); });
}

/// Mean distance in mm of the contours' points from the circle; large when there is more than one contour.
double error_mm(const LevelSetResult<2>& result) {
  const auto contours = trace_contours(image_of(result.phi), {1, 1});
  return contours.size() == 1 ? test::distances_to({centre.x(), centre.y(), radius}, contours).mean : 1e9;
}

TEST(LevelSetPhantom, RegionsFindTheDiscAtEveryNoise) {
  // Without noise the curvature alone shifts the edge by about β/r times the edge's width, 0.07 mm.
  const double bounds[] = {0.5, 0.2, 0.15}, cnrs[] = {2, 4, 8};
  for (int i = 0; i < 3; ++i)
    for (unsigned seed = 1; seed <= 5; ++seed)
      for (const double initial : {14.0, 26.0}) {
        RegionTerm<2> regions(filtered(picture({.cnr = cnrs[i]}, seed), 1.2));
        CurvatureTerm<2> curvature(1);
        LevelSetOptions options;
        options.max_steps = 600;
        EXPECT_LT(error_mm(evolve<2>(start(initial), {&regions, &curvature}, options)), bounds[i])
            << cnrs[i] << ", seed " << seed;
      }
}

TEST(LevelSetPhantom, IsosurfaceAndRangeFindTheDiscAtContrastToNoiseFour) {
  constexpr int seeds = 6;
  double by_isosurface = 0, by_range = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const SharedField<2> image = filtered(picture({.cnr = 4}, seed), 1.2);
    IsosurfaceTerm<2> isosurface(image, 60, 1);
    ThresholdRangeTerm<2> range(image, 60, 220, 40);
    CurvatureTerm<2> curvature(1);
    LevelSetOptions options;
    options.max_steps = 600;
    by_isosurface += error_mm(evolve<2>(start(17), {&isosurface, &curvature}, options)) / seeds;
    by_range += error_mm(evolve<2>(start(17), {&range, &curvature}, options)) / seeds;
  }
  EXPECT_LT(by_isosurface, 0.2);  // a fifth of a pixel
  EXPECT_LT(by_range, 0.2);
}

TEST(LevelSetPhantom, LocalMeansWithstandABiasThatGlobalMeansDoNot) {
  const SharedField<2> image = picture({.cnr = 8, .bias = 0.8}, 3);
  LevelSetOptions options;
  options.max_steps = 400;
  CurvatureTerm<2> curvature(1);
  RegionTerm<2> global(image), local(image, {.window_mm = 6});
  const double with_global = error_mm(evolve<2>(start(18), {&global, &curvature}, options));
  const double with_local = error_mm(evolve<2>(start(18), {&local, &curvature}, options));
  EXPECT_LT(with_local, 0.25);
  EXPECT_GT(with_global, 2 * with_local);
}

TEST(LevelSetPhantom, GeodesicEdgeHoldsABlurredEdgeAndABalloonReachesIt) {
  const SharedField<2> image = picture({.blur_mm = 2}, 0);
  EdgeTerm<2> edge(image, {.contrast = 5, .length_mm = 1, .balloon = 0.15});
  LevelSetOptions options;
  options.max_steps = 1500;
  EXPECT_LT(error_mm(evolve<2>(start(10), {&edge}, options)), 0.3);  // the balloon leans on the edge
  EdgeTerm<2> pure(image, {.contrast = 5, .length_mm = 1});
  EXPECT_LT(error_mm(evolve<2>(start(21.5), {&pure}, options)), 0.2);
}

}  // namespace
}  // namespace isostack

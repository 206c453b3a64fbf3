// Motions whose solution is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "segmentation/derivatives.h"
#include "segmentation/level_set.h"
#include "segmentation/trace_contours.h"
#include "tests/segmentation/fields.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::field_from;

/// A disc or ball about the middle of a lattice with a margin of 8 mm around it.
template <int D>
Field<D> ball(double radius, const std::array<double, D>& spacing_mm) {
  const Eigen::Matrix<double, D, 1> middle = Eigen::Matrix<double, D, 1>::Constant(radius + 8.37);
  std::array<int, D> size;
  for (int axis = 0; axis < D; ++axis) size[axis] = static_cast<int>(2 * middle[axis] / spacing_mm[axis]) + 1;
  return field_from<D>(size, spacing_mm, [&](const auto& p) { return radius - (p - middle).norm(); });
}

double area_mm2(const Field<2>& phi) {
  return test::total_area_mm2(trace_contours(image_of(phi), {phi.spacing_mm[0], phi.spacing_mm[1]}));
}

template <int D>
LevelSetResult<D> flow(Field<D> phi, SpeedTerm<D>& term, double time_mm) {
  LevelSetOptions options;
  options.max_steps = 100000;
  options.max_time_mm = time_mm;
  options.tolerance_pixels = 0;
  return evolve<D>(std::move(phi), {&term}, options);
}

/// Smallest and largest radius of the zero set, from its crossings with the lattice lines.
template <int D>
std::array<double, 2> radii(const Field<D>& phi, double middle_mm) {
  std::array<double, 2> found = {1e9, 0};
  for (std::size_t node = 0; node < phi.values.size(); ++node)
    for (int axis = 0; axis < D; ++axis) {
      const auto at = phi.position_of(node);
      if (at[axis] + 1 >= phi.size[axis]) continue;
      const double a = phi.values[node], b = phi.values[node + phi.stride(axis)];
      if ((a >= 0) == (b >= 0)) continue;
      double squared = 0;
      for (int i = 0; i < D; ++i)
        squared += std::pow((at[i] + (i == axis ? a / (a - b) : 0)) * phi.spacing_mm[i] - middle_mm, 2);
      found = {std::min(found[0], std::sqrt(squared)), std::max(found[1], std::sqrt(squared))};
    }
  return found;
}

/// | |∇φ| − 1 | in a band of `band_mm` where the middle of the ball is far.
template <int D>
void expect_distance(const Field<D>& phi, double middle_mm, double band_mm) {
  const double away_mm = 3 * *std::max_element(phi.spacing_mm.begin(), phi.spacing_mm.end());
  int checked = 0;
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    if (std::abs(phi.values[node]) > band_mm) continue;
    double squared = 0;
    const auto at = phi.position_of(node);
    for (int i = 0; i < D; ++i) squared += std::pow(at[i] * phi.spacing_mm[i] - middle_mm, 2);
    if (squared < away_mm * away_mm) continue;
    ASSERT_NEAR(derivatives_at(phi, node).gradient().norm(), 1, 0.05) << std::sqrt(squared);
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(LevelSetFlow, CircleUnderCurvatureFollowsItsLaw) {
  for (const auto& spacing_mm : {std::array{1.0, 1.0}, std::array{0.7, 1.2}})
    for (const double initial : {10.0, 20.0})
      for (const double share : {0.25, 0.5, 0.75}) {
        const double time_mm = share * initial * initial / 2;
        CurvatureTerm<2> curvature(1);
        const auto result = flow<2>(ball<2>(initial, spacing_mm), curvature, time_mm);
        const double expected = initial * initial - 2 * time_mm;
        EXPECT_NEAR(area_mm2(result.phi) / std::numbers::pi, expected, 0.01 * expected) << initial << ", " << share;
        expect_distance<2>(result.phi, initial + 8.37, 3);
      }
}

TEST(LevelSetFlow, BallUnderCurvatureFollowsItsLaw) {
  const double initial = 12, time_mm = 18;
  CurvatureTerm<3> curvature(1);
  const auto result = flow<3>(ball<3>(initial, {1, 1, 1.2}), curvature, time_mm);
  const double expected = std::sqrt(initial * initial - 4 * time_mm);
  const auto [smallest, largest] = radii<3>(result.phi, initial + 8.37);
  EXPECT_NEAR(smallest, expected, 0.01 * expected);
  EXPECT_NEAR(largest, expected, 0.01 * expected);
  expect_distance<3>(result.phi, initial + 8.37, 3);
}

TEST(LevelSetFlow, NormalMotionMovesEveryPointByTheTime) {
  for (const auto& spacing_mm : {std::array{1.0, 1.0}, std::array{0.7, 1.2}})
    for (const double speed : {1.0, -1.0})
      for (const double time_mm : {1.7, 5.0}) {
        ConstantTerm<2> propagator(speed);
        const auto result = flow<2>(ball<2>(14, spacing_mm), propagator, time_mm);
        const auto [smallest, largest] = radii<2>(result.phi, 22.37);
        EXPECT_NEAR(smallest, 14 + speed * time_mm, 0.05 * spacing_mm[1]);
        EXPECT_NEAR(largest, 14 + speed * time_mm, 0.05 * spacing_mm[1]);
        expect_distance<2>(result.phi, 22.37, 3);
      }
}

TEST(LevelSetFlow, NormalMotionOfABall) {
  for (const double speed : {1.0, -1.0}) {
    ConstantTerm<3> propagator(speed);
    const auto result = flow<3>(ball<3>(12, {1, 1, 1.2}), propagator, 4);
    const auto [smallest, largest] = radii<3>(result.phi, 20.37);
    EXPECT_NEAR(smallest, 12 + speed * 4, 0.06);
    EXPECT_NEAR(largest, 12 + speed * 4, 0.06);
  }
}

TEST(LevelSetFlow, DilationRoundsCornersAndErosionKeepsThem) {
  const auto square = field_from<2>(
      {60, 60}, {1, 1}, [](const auto& p) { return 12.3 - (p - Eigen::Vector2d(29.6, 29.6)).cwiseAbs().maxCoeff(); });
  ConstantTerm<2> dilate(1), erode(-1);
  const double side = 24.6, t = 5;
  const double rounded = side * side + 4 * side * t + std::numbers::pi * t * t;
  EXPECT_NEAR(area_mm2(flow<2>(square, dilate, t).phi), rounded, 0.01 * rounded);
  const double sharp = (side - 2 * t) * (side - 2 * t);
  EXPECT_NEAR(area_mm2(flow<2>(square, erode, t).phi), sharp, 0.01 * sharp);  // corners are blunt by a pixel
}

/// Relative errors of the area where a smooth bump is above half its height, r² = 2 σ² ln 2, for ever smaller pixels.
template <class MakeTerm>
std::vector<double> area_errors(MakeTerm make_term) {
  const double sigma = 9, expected = std::numbers::pi * 2 * sigma * sigma * std::numbers::ln2;
  std::vector<double> errors;
  for (const double h : {2.0, 1.0, 0.5}) {
    const int n = static_cast<int>(50 / h);
    const Eigen::Vector2d middle(24.3, 24.8);
    const auto image = field_from<2>(
        {n, n}, {h, h}, [&](const auto& p) { return std::exp(-(p - middle).squaredNorm() / (2 * sigma * sigma)); });
    const auto start = field_from<2>({n, n}, {h, h}, [&](const auto& p) { return 8 - (p - middle).norm(); });
    auto term = make_term(image, h);
    LevelSetOptions options;
    options.max_steps = 500;
    options.tolerance_pixels = 1e-6;
    errors.push_back(std::abs(area_mm2(evolve<2>(start, {&term}, options).phi) - expected) / expected);
  }
  return errors;
}

TEST(LevelSetFlow, AreaErrorFallsWithTheSquareOfThePixel) {
  const auto by_range = area_errors([](const auto& image, double) { return ThresholdRangeTerm<2>(image, 0.5, 2); });
  EXPECT_LT(by_range[0], 0.01);
  EXPECT_LT(by_range[1], by_range[0] / 3.5);
  EXPECT_LT(by_range[2], by_range[1] / 3.5);
  // g bends within a pixel, whose place on the lattice then shows a little: the order holds over several halvings.
  const auto by_isosurface = area_errors([](const auto& image, double h) { return IsosurfaceTerm<2>(image, 0.5, h); });
  EXPECT_LT(by_isosurface[0], 0.01);
  EXPECT_LT(by_isosurface[2], by_isosurface[0] / 10);
}

}  // namespace
}  // namespace isostack

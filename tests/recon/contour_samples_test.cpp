#include "recon/constraints/contour_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;

ContourStack one_slice(std::vector<Contour> contours, double pixel_mm = 1) {
  ContourStack stack{.name = "organ", .slices = {}};
  stack.slices.push_back({.name = "s", .pose = {}, .contours = std::move(contours)});
  stack.slices[0].pose.spacing_mm = {pixel_mm, pixel_mm};
  return stack;
}

bool is_point_of(const ContourStack& stack, const ContourSample& sample) {
  const auto& contours = stack.slices[sample.slice].contours;
  return std::any_of(contours.begin(), contours.end(), [&](const Contour& contour) {
    return std::find(contour.points_mm.begin(), contour.points_mm.end(), sample.point_in_slice_mm) !=
           contour.points_mm.end();
  });
}

/// Corners rounded with a small radius, long nearly straight sides; points every half millimetre.
Contour rounded_square(double half_side_mm, double corner_mm) {
  Contour contour;
  const double straight = half_side_mm - corner_mm;
  for (int side = 0; side < 4; ++side) {
    const Eigen::Rotation2Dd turn(side * std::numbers::pi / 2);
    for (double y = -straight; y < straight; y += 0.5)
      contour.points_mm.push_back(turn * Eigen::Vector2d(half_side_mm, y));
    for (double angle = 0; angle < std::numbers::pi / 2; angle += 0.5 / corner_mm)
      contour.points_mm.push_back(
          turn * (Eigen::Vector2d(straight, straight) + corner_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return contour;
}

TEST(SampleContours, KeepsEveryPointWhenThereIsRoom) {
  const ContourStack stack = one_slice({circle({5, 5}, 20, 100), circle({5, 5}, 8, 40, true)});  // 1.26 mm apart
  EXPECT_EQ(sample_contours(stack, {}).size(), 140u);
}

TEST(SampleContours, KeepsEveryPointOfAnArcThoughItsChordIsLong) {
  Contour half_disc;
  for (int i = 0; i <= 60; ++i) {
    const double angle = std::numbers::pi * i / 60;
    half_disc.points_mm.push_back(20 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));  // 1.05 mm apart
  }
  EXPECT_EQ(sample_contours(one_slice({half_disc}), {}).size(), 61u);
}

TEST(SampleContours, PointsNearerThanTheSpacingAreLeftOutAlsoNextToALongEdge) {
  Contour half_disc;
  for (int i = 0; i <= 600; ++i) {
    const double angle = std::numbers::pi * i / 600;
    half_disc.points_mm.push_back(20 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));  // 0.1 mm apart
  }
  const auto samples = sample_contours(one_slice({half_disc}), {});
  for (std::size_t i = 1; i < samples.size(); ++i)  // one point's distance of slack: samples are given points
    EXPECT_GT((samples[i].point_in_slice_mm - samples[i - 1].point_in_slice_mm).norm(), 0.75 - 0.11) << i;
  EXPECT_GT(samples.size(), 70u);  // 62.8 mm of arc
}

TEST(SampleContours, ThinsToTheLimitAndInventsNoPoint) {
  ContourStack stack = one_slice({circle({0, 0}, 50, 600), circle({0, 0}, 20, 250, true)});
  stack.slices.push_back(stack.slices[0]);
  for (const std::size_t limit : {24u, 100u, 333u, 1000u}) {
    const auto samples = sample_contours(stack, {.max_samples = limit});
    EXPECT_LE(samples.size(), limit);
    EXPECT_GE(samples.size(), limit * 8 / 10) << "the room is used";
    for (const ContourSample& sample : samples) ASSERT_TRUE(is_point_of(stack, sample));
  }
}

TEST(SampleContours, LeavesSomePointsOnEveryContour) {
  const ContourStack stack = one_slice({circle({0, 0}, 80, 2000), circle({200, 0}, 2, 30)});
  const auto samples = sample_contours(stack, {.max_samples = 60});
  const auto on_small = std::count_if(samples.begin(), samples.end(),
                                      [](const ContourSample& s) { return s.point_in_slice_mm.x() > 150; });
  EXPECT_GE(on_small, 6);
  EXPECT_GE(static_cast<long>(samples.size()) - on_small, 20);
}

TEST(SampleContours, IsDenseWhereTheContourCurves) {
  const ContourStack stack = one_slice({rounded_square(50, 5)});
  const auto samples = sample_contours(stack, {.max_samples = 100});
  std::size_t on_corners = 0;
  for (const ContourSample& s : samples) on_corners += s.point_in_slice_mm.cwiseAbs().minCoeff() > 44.9 ? 1 : 0;
  // Corners are 31 of 391 mm; straight sides count as of radius 50: √10 times sparser.
  const double corner_density = static_cast<double>(on_corners) / (10 * std::numbers::pi);
  const double side_density = static_cast<double>(samples.size() - on_corners) / 360;
  EXPECT_GT(corner_density / side_density, 2);
  EXPECT_LT(corner_density / side_density, 4.5);
}

TEST(SampleContours, InwardPointsIntoTheOrganAlsoAtHoles) {
  const ContourStack stack = one_slice({circle({0, 0}, 30, 190), circle({0, 0}, 12, 75, true)});
  for (const ContourSample& sample : sample_contours(stack, {})) {
    const bool outer = sample.point_in_slice_mm.norm() > 20;
    const Eigen::Vector2d expected = (outer ? -1 : 1) * sample.point_in_slice_mm.normalized();
    EXPECT_LT((sample.inward - expected).norm(), 1e-3);  // the chords' tangent is symmetric on a circle
  }
}

TEST(SampleContours, RefusesMoreContoursThanFit) {
  std::vector<Contour> many;
  for (int i = 0; i < 11; ++i) many.push_back(circle({10.0 * i, 0}, 3, 12));
  EXPECT_THROW(sample_contours(one_slice(many), {.max_samples = 32}), SolveError);
  EXPECT_LE(sample_contours(one_slice(many), {.max_samples = 33}).size(), 33u);
}

TEST(SampleContours, OfNothingIsNothing) { EXPECT_TRUE(sample_contours(one_slice({}), {}).empty()); }

}  // namespace
}  // namespace isostack

#include "recon/morphing/signed_distance_morph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::largest_distance;
using testing_support::moved;
using testing_support::o_figure;
using testing_support::sphere_mesh;
using testing_support::x_figure;

constexpr double traced_mm = 0.02;  // chords of two traced curves, each within a hundredth of a pixel

/// How far a frame is from the circle about (50, 50) with this radius.
double off_circle(const Shape& frame, double radius_mm) {
  return largest_distance(contours_of(frame), contours_of(disc("", {50, 50}, radius_mm).shape));
}

std::vector<KeyShape> discs(const std::vector<double>& radii_mm) {
  std::vector<KeyShape> shapes;
  for (const double radius : radii_mm) shapes.push_back(disc("disc", {50, 50}, radius));
  return shapes;
}

TEST(SignedDistanceMorph, RadiiOfDiscsChangeEvenly) {
  const Morph morph = signed_distance_morph(discs({10, 30}), {});
  for (const double t : {0.0, 0.25, 0.5, 1.0}) EXPECT_LT(off_circle(morph.shape_at(t), 10 + 20 * t), traced_mm);
}

TEST(SignedDistanceMorph, OnALineOnlyTheNeighboursCount) {
  std::vector<KeyShape> shapes = discs({10, 30, 20});
  shapes[0].time = 0;
  shapes[1].time = 3;
  shapes[2].time = 4;
  const Morph morph = signed_distance_morph(shapes, {});
  EXPECT_LT(off_circle(morph.shape_at(0.375), 20), traced_mm);
  EXPECT_LT(off_circle(morph.shape_at(0.75), 30), traced_mm);
  EXPECT_LT(off_circle(morph.shape_at(0.875), 25), traced_mm);
}

TEST(SignedDistanceMorph, CubicIsTheNaturalSplineThroughAllKeyShapes) {
  const Morph morph = signed_distance_morph(discs({20, 10, 20}), {.between = AlongNormal::cubic});
  EXPECT_LT(off_circle(morph.shape_at(0.5), 10), traced_mm);
  // Second derivative in the middle 3/2 · (20 − 2·10 + 20) = 30; half way to it 15 + (1/8 − 1/2) / 6 · 30.
  EXPECT_LT(off_circle(morph.shape_at(0.25), 13.125), traced_mm);
}

TEST(SignedDistanceMorph, OfCornersIsTheWeightedMean) {
  const Morph morph = signed_distance_morph(discs({10, 20, 40}), {.layout = KeyLayout::simplex});
  EXPECT_LT(off_circle(morph.at(Eigen::Vector3d(0.5, 0.3, 0.2)), 19), traced_mm);
  EXPECT_THROW(
      signed_distance_morph(discs({10, 20, 40}), {.layout = KeyLayout::simplex, .between = AlongNormal::cubic}),
      InputError);
}

TEST(SignedDistanceMorph, EndFramesAreTheGivenShapes) {
  const auto frames = signed_distance_morph({x_figure(), o_figure()}, {}).frames(2);
  EXPECT_LT(largest_distance(contours_of(frames[0]), contours_of(x_figure().shape)), traced_mm);
  EXPECT_LT(largest_distance(contours_of(frames[1]), contours_of(o_figure().shape)), traced_mm);
}

TEST(SignedDistanceMorph, BackwardsAndMovedItIsTheSame) {
  const Morph there = signed_distance_morph({x_figure(), o_figure()}, {});
  const Morph back = signed_distance_morph({o_figure(), x_figure()}, {});
  const Eigen::Vector2d shift(3.3, 7.7);
  const Morph turned = signed_distance_morph({moved(x_figure(), 0.7, shift), moved(o_figure(), 0.7, shift)}, {});
  for (const double t : {0.1, 0.3, 0.8}) {
    const KeyShape frame{.name = "frame", .shape = there.shape_at(t)};
    EXPECT_LT(largest_distance(contours_of(frame.shape), contours_of(back.shape_at(1 - t))), traced_mm);
    EXPECT_LT(largest_distance(contours_of(moved(frame, 0.7, shift).shape), contours_of(turned.shape_at(t))),
              traced_mm);
  }
}

TEST(SignedDistanceMorph, SpacetimeFieldIsTheDistanceWithItsSlope) {
  const Morph morph = signed_distance_morph(discs({10, 30}), {});
  const SpacetimeField spacetime = *morph.spacetime();
  const double length_mm = morph.report().spacing_mm;
  const Eigen::Vector3d place(50 + 12, 50, 0.25 * length_mm);  // there the disc has a radius of 15 mm
  EXPECT_NEAR(spacetime.field.values(place)[0], 3, 0.01);      // the circles are polygons
  EXPECT_LT((spacetime.field.gradients(place) - Eigen::Vector3d(-1, 0, 20 / length_mm)).norm(), 0.01);
}

KeyShape ball(double radius_mm) { return {.name = "ball", .shape = sphere_mesh({1, 2, 3}, radius_mm, 60, 40)}; }

TEST(SignedDistanceMorph, OfBallsHasBallsBetween) {
  const Morph morph = signed_distance_morph({ball(10), ball(20)}, {.resolution_mm = 1});
  for (const double t : {0.0, 0.5, 1.0}) {
    const auto frame = std::get<TriangleMesh>(morph.shape_at(t));
    EXPECT_TRUE(measure(frame).watertight());
    EXPECT_GT(measure(frame).volume_mm3, 0);
    // Facets of the given balls are 0.06 mm deep at most; between the grid's nodes a distance to a sphere of radius r
    // is linear to 3 · 1 / 8 / r.
    for (const Eigen::Vector3d& v : frame.vertices_mm)
      ASSERT_NEAR((v - Eigen::Vector3d(1, 2, 3)).norm(), 10 + 10 * t, 0.06 + 0.375 / (10 + 10 * t));
  }
}

TEST(SignedDistanceMorph, MayVanishBetweenBodiesApart) {
  const KeyShape left{.name = "left", .shape = sphere_mesh({0, 0, 0}, 5, 40, 20)};
  const KeyShape right{.name = "right", .shape = sphere_mesh({30, 0, 0}, 5, 40, 20)};
  const Morph morph = signed_distance_morph({left, right}, {.resolution_mm = 1});
  EXPECT_TRUE(std::get<TriangleMesh>(morph.shape_at(0.5)).triangles.empty());
}

TEST(SignedDistanceMorph, GridsBeyondTheMemoryAllowedAreRefused) {
  EXPECT_THROW(signed_distance_morph({ball(10), ball(20)}, {.resolution_mm = 1e-3}), SolveError);
  EXPECT_THROW(signed_distance_morph({ball(10), ball(20)}, {.resolution_mm = 1e-12}), SolveError);
}

}  // namespace
}  // namespace isostack

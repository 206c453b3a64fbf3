#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/morphing/signed_distance_morph.h"
#include "recon/morphing/variational_morph.h"
#include "recon/morphing/warp.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::largest_distance;
using testing_support::o_figure;
using testing_support::sphere_mesh;
using testing_support::x_figure;

Morph variational(const std::vector<KeyShape>& shapes) { return variational_morph(shapes, {}); }
Morph by_distance(const std::vector<KeyShape>& shapes) { return signed_distance_morph(shapes, {.resolution_mm = 1}); }

/// Four points of a circle and where they are on another: shifted and grown.
std::vector<LandmarkPair> rim_points(const Eigen::Vector3d& from, double from_mm, const Eigen::Vector3d& to,
                                     double to_mm) {
  std::vector<LandmarkPair> pairs;
  for (int i = 0; i < 4; ++i) {
    const double angle = 0.3 + std::numbers::pi / 2 * i;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
    pairs.push_back({from + from_mm * out, to + to_mm * out});
  }
  return pairs;
}

/// The ends of the X's bars turn by an eighth of a circle on the O, and move in or out a little.
std::vector<LandmarkPair> turning_points() {
  std::vector<LandmarkPair> pairs;
  for (int i = 0; i < 4; ++i) {
    const double from = std::numbers::pi / 4 + std::numbers::pi / 2 * i, to = from + 0.4;
    pairs.push_back({Eigen::Vector3d(50 + 50.4 * std::cos(from), 50 + 50.4 * std::sin(from), 0),
                     Eigen::Vector3d(50 + 38 * std::cos(to), 50 + 38 * std::sin(to), 0)});
  }
  return pairs;
}

TEST(HalfwayWarp, CorrespondingPointsMeetAtTheEndsAndAreHalfWayBetween) {
  const std::vector<LandmarkPair> pairs = turning_points();
  const HalfwayWarp warp({x_figure(), o_figure()}, pairs);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const LandmarkPair& pair = pairs[static_cast<std::size_t>(i)];
    EXPECT_LT((warp.landmarks_at(0).col(i) - pair.from_mm.head<2>()).norm(), 1e-6);
    EXPECT_LT((warp.landmarks_at(1).col(i) - pair.to_mm.head<2>()).norm(), 1e-6);
    EXPECT_LT((warp.landmarks_at(0.5).col(i) - (pair.from_mm + pair.to_mm).head<2>() / 2).norm(), 1e-6);
  }
}

TEST(HalfwayWarp, SoDoThoseOfBodies) {
  const KeyShape from{.name = "from", .shape = sphere_mesh({0, 0, 0}, 20, 40, 20)};
  const KeyShape to{.name = "to", .shape = sphere_mesh({5, 8, 0}, 25, 40, 20)};
  std::vector<LandmarkPair> pairs = rim_points({0, 0, 0}, 20, {5, 8, 0}, 25);
  pairs.push_back({{0, 0, 20}, {7, 8, 24}});
  pairs.push_back({{0, 0, -20}, {5, 8, -25}});
  const HalfwayWarp warp({from, to}, pairs);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const LandmarkPair& pair = pairs[static_cast<std::size_t>(i)];
    EXPECT_LT((warp.landmarks_at(0).col(i) - pair.from_mm).norm(), 1e-6);
    EXPECT_LT((warp.landmarks_at(1).col(i) - pair.to_mm).norm(), 1e-6);
    EXPECT_LT((warp.landmarks_at(0.5).col(i) - (pair.from_mm + pair.to_mm) / 2).norm(), 1e-6);
  }
}

TEST(WarpedMorph, OfAShiftedAndGrownDiscShiftsAndGrowsIt) {
  const std::vector<KeyShape> shapes = {disc("from", {35, 50}, 12), disc("to", {65, 50}, 18)};
  const std::vector<LandmarkPair> pairs = rim_points({35, 50, 0}, 12, {65, 50, 0}, 18);
  // Displaced half-way both are the disc about (50, 50) of 15 mm; from there displacements are linear.
  const auto truth = [](double t) { return contours_of(disc("", {35 + 30 * t, 50}, 12 + 6 * t).shape); };
  const Morph linear = warped_morph(shapes, pairs, by_distance), smooth = warped_morph(shapes, pairs, variational);
  EXPECT_EQ(smooth.report().landmarks, 4u);
  for (const double t : {0.0, 0.5, 1.0})
    EXPECT_LT(largest_distance(contours_of(linear.shape_at(t)), truth(t)), 0.1) << t;
  for (const double t : {0.0, 1.0}) EXPECT_LT(largest_distance(contours_of(smooth.shape_at(t)), truth(t)), 0.1) << t;
  // The variational morph of two equal discs bulges between them, by a twentieth at this spacing.
  EXPECT_LT(largest_distance(contours_of(smooth.shape_at(0.5)), truth(0.5)), 0.06 * 15);
  // Without correspondence the disc does not travel.
  EXPECT_GT(largest_distance(contours_of(variational(shapes).shape_at(0.5)), contours_of(disc("", {50, 50}, 15).shape)),
            3);
}

TEST(WarpedMorph, OfAShiftedBallShiftsIt) {
  const KeyShape from{.name = "from", .shape = sphere_mesh({0, 0, 0}, 10, 60, 40)};
  const KeyShape to{.name = "to", .shape = sphere_mesh({30, 0, 0}, 10, 60, 40)};
  const Morph morph = warped_morph({from, to}, {{{10, 0, 0}, {40, 0, 0}}}, by_distance);
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const auto frame = std::get<TriangleMesh>(morph.shape_at(t));
    ASSERT_FALSE(frame.vertices_mm.empty());
    for (std::size_t i = 0; i < frame.vertices_mm.size(); ++i) {
      const Eigen::Vector3d out = frame.vertices_mm[i] - Eigen::Vector3d(30 * t, 0, 0);
      ASSERT_NEAR(out.norm(), 10, 0.1);  // facets 0.03 mm deep, a grid of 1 mm
      ASSERT_GT(frame.normals[i].dot(out.normalized()), 0.97);
    }
  }
}

TEST(WarpedMorph, EndFramesAreTheGivenShapesWithinATenthOfAPixel) {
  const Morph morph = warped_morph({x_figure(), o_figure()}, turning_points(), variational);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(0)), contours_of(x_figure().shape)), 0.1);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(1)), contours_of(o_figure().shape)), 0.1);
}

TEST(WarpedMorph, SpacetimeFieldAgreesWithItsFramesAndItsSlopes) {
  const Morph morph = warped_morph({x_figure(), o_figure()}, turning_points(), variational);
  const SpacetimeField spacetime = *morph.spacetime();
  for (const double t : {0.0, 0.2, 0.8}) {
    const Eigen::Vector2d point = contours_of(morph.shape_at(t)).front().points_mm[5];
    const Eigen::Vector3d place(point.x(), point.y(), t * morph.report().spacing_mm);
    EXPECT_NEAR(spacetime.field.values(place)[0], 0, 1e-4);  // roots are found to a millionth of a pixel
    if (t == 0) continue;                                    // time ends there
    const Eigen::Vector3d gradient = spacetime.field.gradients(place);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-4 * Eigen::Vector3d::Unit(axis);
      const double slope = (spacetime.field.values(place + step)[0] - spacetime.field.values(place - step)[0]) / 2e-4;
      EXPECT_NEAR(gradient[axis], slope, 1e-4);
    }
  }
}

/// What the refusal of these landmarks says.
std::string refusal(const std::vector<LandmarkPair>& pairs, std::vector<KeyShape> shapes = {x_figure(), o_figure()}) {
  try {
    HalfwayWarp(shapes, pairs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WarpedMorph, SaysWhatIsWrongWithLandmarks) {
  std::vector<LandmarkPair> pairs = turning_points();
  EXPECT_EQ(refusal(pairs), "");
  EXPECT_NE(refusal({}).find("there are none"), std::string::npos);
  EXPECT_NE(refusal(pairs, {x_figure(), o_figure(), x_figure()}).find("two shapes"), std::string::npos);
  pairs.push_back({pairs[0].from_mm, pairs[1].to_mm});
  EXPECT_NE(refusal(pairs).find("landmark 5: it is the same point as landmark 1"), std::string::npos);
  pairs.back() = pairs[0];  // said twice
  EXPECT_EQ(refusal(pairs), "");
  pairs.back() = {{500, 50, 0}, {50, 88, 0}};
  EXPECT_NE(refusal(pairs).find("landmark 5: it is 4"), std::string::npos);  // some 440 mm outside
  pairs.back() = {{50, 88, 2}, {50, 88, 0}};
  EXPECT_NE(refusal(pairs).find("landmark 5: it is 2 mm off the plane of X"), std::string::npos);
  pairs.back() = {{50, std::nan(""), 0}, {50, 88, 0}};
  EXPECT_NE(refusal(pairs).find("landmark 5"), std::string::npos);
}

TEST(WarpedMorph, ThatFoldsAShapeOverIsRefused) {
  const std::vector<LandmarkPair> crossed = {
      {{20, 20, 0}, {80, 20, 0}}, {{80, 20, 0}, {20, 20, 0}}, {{20, 80, 0}, {20, 80, 0}}, {{80, 80, 0}, {80, 80, 0}}};
  EXPECT_THROW(HalfwayWarp({x_figure(), o_figure()}, crossed), GeometryError);
}

}  // namespace
}  // namespace isostack

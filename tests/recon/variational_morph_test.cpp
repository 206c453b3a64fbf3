#include "recon/morphing/variational_morph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/contour_fit.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/frame_quality.h"
#include "recon/morphing/densified.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::largest_distance;
using testing_support::moved;
using testing_support::o_figure;
using testing_support::x_figure;

constexpr double traced_mm = 0.02;  // chords of two traced frames, each within a hundredth of a pixel of its curve

/// A square given by its corners alone.
KeyShape square() {
  ContourSlice slice;
  slice.contours = {{.points_mm = {{31, 20}, {80, 31}, {69, 80}, {20, 69}}}};
  return {.name = "square", .shape = slice};
}

/// Points of space-time all over the morph's box, the same every time.
Eigen::Matrix3Xd places_in(const Eigen::AlignedBox3d& box) {
  Eigen::Matrix3Xd places(3, 500);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const double k = static_cast<double>(i) + 1;  // an additive recurrence fills the box evenly
    const Eigen::Array3d share(std::fmod(k * 0.8191725, 1), std::fmod(k * 0.6710436, 1), std::fmod(k * 0.5497005, 1));
    places.col(i) = box.min().array() + share * box.sizes().array();
  }
  return places;
}

/// Round the figures of this file, from the first key shape to the last.
Eigen::AlignedBox3d box_with_time(const Morph& morph) {
  return {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(100, 100, morph.report().spacing_mm)};
}

class OfBothRecipes : public testing::TestWithParam<MorphRecipe> {};
INSTANTIATE_TEST_SUITE_P(VariationalMorph, OfBothRecipes,
                         testing::Values(MorphRecipe::signed_distance, MorphRecipe::turk_obrien));

TEST_P(OfBothRecipes, EndFramesAreTheGivenShapesWithinATenthOfAPixel) {
  for (const KeyShape& from : {x_figure(), disc("disc", {45, 55}, 20)}) {
    const auto frames = variational_morph({from, o_figure()}, {.recipe = GetParam()}).frames(2);
    EXPECT_LT(largest_distance(contours_of(frames[0]), contours_of(from.shape)), 0.1);
    EXPECT_LT(largest_distance(contours_of(frames[1]), contours_of(o_figure().shape)), 0.1);
  }
}

TEST_P(OfBothRecipes, TopologyChangesByItself) {
  const Morph morph = variational_morph({x_figure(), o_figure()}, {.recipe = GetParam()});
  const FrameQuality x = frame_quality(morph.shape_at(0)), o = frame_quality(morph.shape_at(1));
  EXPECT_EQ(x.components, 1u);
  EXPECT_EQ(x.holes, 0u);
  EXPECT_EQ(o.components, 1u);
  EXPECT_EQ(o.holes, 1u);
}

TEST(VariationalMorph, PolygonsKeepTheirCornersWithinATenthOfAPixel) {
  const auto frames = variational_morph({square(), o_figure()}, {}).frames(2);
  EXPECT_LT(largest_distance(contours_of(frames[0]), contours_of(square().shape)), 0.1);
}

TEST(VariationalMorph, TheFiguresOwnImageGivesThePapersConstraints) {
  // A disc whose grey values rise by 50 per pixel: halfway grey is its rim. Another level means another radius.
  const KeyShape drawn = disc("disc", {50, 50}, 20);
  KeyShape grey = drawn;
  grey.image = GreyFigure{Image<float>(101, 101), 100 + 50 * 3};
  for (int row = 0; row <= 100; ++row)
    for (int column = 0; column <= 100; ++column)
      grey.image->pixels(row, column) = static_cast<float>(100 + 50 * (20 - std::hypot(column - 50, row - 50)));
  const Morph morph = variational_morph({grey, drawn}, {.recipe = MorphRecipe::turk_obrien});
  const KeyShape inner = disc("inner", {50, 50}, 17);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(0)), contours_of(inner.shape)), 0.1);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(1)), contours_of(drawn.shape)), 0.1);
}

TEST(VariationalMorph, BackwardsItIsTheSameFunction) {
  const Morph there = variational_morph({x_figure(), o_figure()}, {});
  const Morph back = variational_morph({o_figure(), x_figure()}, {});
  const SpacetimeField forwards = *there.spacetime(), backwards = *back.spacetime();
  const Eigen::Matrix3Xd places = places_in(box_with_time(there));
  Eigen::Matrix3Xd mirrored = places;
  mirrored.row(2) = there.report().spacing_mm - places.row(2).array();
  const double residual = std::max(there.report().solve.largest_residual, back.report().solve.largest_residual);
  const Eigen::VectorXd difference = forwards.field.values(places) - backwards.field.values(mirrored);
  // Both are rounding, of one system whose rows come in another order; the field itself is of order 1.
  EXPECT_LE(difference.cwiseAbs().maxCoeff(), std::max(10 * residual, 1e-7));
  for (const double t : {0.1, 0.3, 0.7})
    EXPECT_LT(largest_distance(contours_of(there.shape_at(t)), contours_of(back.shape_at(1 - t))), traced_mm);
}

TEST(VariationalMorph, MovesWithItsShapes) {
  const double angle = 0.7;
  const Eigen::Vector2d shift(12.3, -45.6);
  const VariationalMorphOptions options{.spacing_mm = 38, .sample_spacing_pixels = 1};
  const Morph still = variational_morph({x_figure(), o_figure()}, options);
  const Morph turned = variational_morph({moved(x_figure(), angle, shift), moved(o_figure(), angle, shift)}, options);
  for (const double t : {0.0, 0.3, 0.7, 1.0}) {
    const KeyShape frame{.name = "frame", .shape = still.shape_at(t)};
    EXPECT_LT(largest_distance(contours_of(moved(frame, angle, shift).shape), contours_of(turned.shape_at(t))),
              traced_mm)
        << "t = " << t;
  }
}

TEST(VariationalMorph, PassesThroughKeyShapesBetween) {
  std::vector<KeyShape> shapes = {disc("a", {50, 50}, 20), x_figure(), o_figure()};
  shapes[0].time = 0;
  shapes[1].time = 3;
  shapes[2].time = 4;
  const Morph morph = variational_morph(shapes, {});
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(0)), contours_of(shapes[0].shape)), 0.1);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(0.75)), contours_of(shapes[1].shape)), 0.1);
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(1)), contours_of(shapes[2].shape)), 0.1);
}

/// The same function: solved for the same constraints, the slices `spacing` apart. A reconstruction goes on from there
/// to correct oblique cuts and what planes object to, which ask for a true distance between the slices.
TEST(VariationalMorph, OfTwoContoursIsTheReconstructionFromTwoSlices) {
  const double spacing_mm = 30;
  std::vector<KeyShape> shapes = {x_figure(), o_figure()};
  ContourStack slices{.name = "slices", .slices = {}};
  for (KeyShape& shape : shapes) {
    auto& figure = std::get<ContourSlice>(shape.shape);
    figure.contours = densified(figure.contours, 0.5);  // as a morph does with edges longer than that
    slices.slices.push_back(figure);
    slices.slices.back().pose.origin_mm.z() = spacing_mm * static_cast<double>(slices.slices.size() - 1);
  }
  const ReconstructOptions first_solve{.solves = 1, .plane_check_rounds = 0, .max_constraints = 20'000};
  ReconstructReport report;
  const Progress silent;
  const ImplicitFunction reconstructed = ContourFit(slices, first_solve, silent, report).run();
  const Morph morph = variational_morph(shapes, {.spacing_mm = spacing_mm});
  EXPECT_EQ(report.constraints, morph.report().constraints);
  const Eigen::Matrix3Xd places = places_in(box_with_time(morph));
  const Eigen::VectorXd difference = reconstructed.values(places) - morph.spacetime()->field.values(places);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-6);  // rounding, in values of up to 40 mm
}

TEST(VariationalMorph, SpacetimeFieldAgreesWithItsFrames) {
  const Morph morph = variational_morph({x_figure(), o_figure()}, {.sample_spacing_pixels = 1});
  const SpacetimeField spacetime = *morph.spacetime();
  EXPECT_DOUBLE_EQ(spacetime.bounds_mm.max().z(), morph.report().spacing_mm);
  for (const double t : {0.2, 0.8})
    for (const Contour& contour : contours_of(morph.shape_at(t)))
      for (const Eigen::Vector2d& p : contour.points_mm) {
        const Eigen::Vector3d place(p.x(), p.y(), t * morph.report().spacing_mm);
        EXPECT_NEAR(spacetime.field.values(place)[0], 0, 1e-4);  // roots are found to a millionth of a pixel
      }
  ASSERT_FALSE(spacetime.seeds_mm.empty());
  EXPECT_NEAR(spacetime.field.values(spacetime.seeds_mm.front())[0], 0, 1e-6);  // a constraint
}

TEST(VariationalMorph, SaysWhatIsWrongWithOptions) {
  const std::vector<KeyShape> two = {x_figure(), o_figure()};
  EXPECT_THROW(variational_morph(two, {.spacing_mm = 0}), InputError);
  EXPECT_THROW(variational_morph(two, {.spacing_mm = std::nan("")}), InputError);
  const std::vector<KeyShape> six(6, x_figure());  // 2 + 5 dimensions
  EXPECT_THROW(variational_morph(six, {.layout = KeyLayout::simplex}), InputError);
}

}  // namespace
}  // namespace isostack

#include "recon/constraints/contour_constraints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;

ContourStack one_slice(std::vector<Contour> contours) {
  ContourStack stack{.name = "organ", .slices = {}};
  stack.slices.push_back({.name = "s", .pose = {}, .contours = std::move(contours)});
  return stack;
}

SlicePose oblique_pose(double pixel_mm) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.9, Eigen::Vector3d(2, -1, 1).normalized()).toRotationMatrix();
  return {
      .origin_mm = 5 * turn.col(0), .x_axis = turn.col(0), .y_axis = turn.col(1), .spacing_mm = {pixel_mm, pixel_mm}};
}

TEST(SignedConstraints, BoundaryIsZeroAndPartnersAreSignedDistances) {
  const double pixel_mm = 0.8, radius_mm = 25;
  const ContourStack stack = sphere_cuts(radius_mm, oblique_pose(pixel_mm), {-10, 0, 12}, 180);
  const ContourConstraints made = signed_constraints(stack, sample_contours(stack, {}), {});
  const auto samples = static_cast<Eigen::Index>(made.samples.size());
  ASSERT_EQ(made.constraints.values.size(), 3 * samples);  // every sample has both partners
  ASSERT_EQ(made.constraints.points.cols(), 3 * samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    EXPECT_EQ(made.constraints.values[i], 0);
    EXPECT_NEAR(made.constraints.points.col(i).norm(), radius_mm, 1e-9);  // in world mm
  }
  int inside = 0;
  for (const ContourConstraints::Partner& partner : made.partners) {
    const ContourSample& sample = made.samples[static_cast<std::size_t>(partner.sample)];
    const SlicePose& pose = stack.slices[sample.slice].pose;
    const Eigen::Vector3d point = made.constraints.points.col(partner.constraint);
    EXPECT_NEAR(pose.signed_distance_mm(point), 0, 1e-9) << "partners stay in the slice's plane";
    const Eigen::Vector2d centre = pose.world_to_slice(Eigen::Vector3d::Zero());
    const double circle_mm = (sample.point_in_slice_mm - centre).norm();
    const double expected = circle_mm - (pose.world_to_slice(point) - centre).norm();
    // The polygon's sagitta: 25 mm · (1 − cos 1°) = 4 µm.
    EXPECT_NEAR(made.constraints.values[partner.constraint], expected, 0.005);
    EXPECT_NEAR(std::abs(expected), pixel_mm, 0.005);
    EXPECT_EQ(made.constraints.values[partner.constraint], partner.in_plane_distance_mm);
    inside += partner.in_plane_distance_mm > 0 ? 1 : 0;
  }
  EXPECT_EQ(inside, samples);
}

TEST(SignedConstraints, PartnersComeNearerWhereTheOrganIsThin) {
  const ContourStack stack = one_slice({{.points_mm = {{0, 0}, {20, 0}, {40, 0}, {40, 1.2}, {20, 1.2}, {0, 1.2}}}});
  const std::vector<ContourSample> samples = {{0, 0, {20, 0}, {0, 1}}};  // the middle of the long side of a 1.2 mm band
  const ContourConstraints made = signed_constraints(stack, samples, {.offset_pixels = 1});
  ASSERT_EQ(made.partners.size(), 2u);
  EXPECT_NEAR(made.partners[0].in_plane_distance_mm, 0.5, 1e-12);  // 1 mm further in is 0.2 mm from the other side
  EXPECT_NEAR(made.partners[1].in_plane_distance_mm, -1, 1e-12);
}

TEST(SignedConstraints, DropsAPartnerThatFindsNoRoom) {
  const ContourStack stack = one_slice({{.points_mm = {{0, 0}, {20, 0}, {40, 0}, {40, 0.05}, {20, 0.05}, {0, 0.05}}}});
  const ContourConstraints made = signed_constraints(stack, {{0, 0, {20, 0}, {0, 1}}}, {.offset_pixels = 1});
  ASSERT_EQ(made.partners.size(), 1u);
  EXPECT_LT(made.partners[0].in_plane_distance_mm, 0);
}

TEST(ObliqueCuts, ValueIsInPlaneDistanceTimesSineOfTheAngle) {
  const double radius_mm = 30;
  const std::vector<double> offsets_mm = {-24, -15, 0, 18};
  const ContourStack stack = sphere_cuts(radius_mm, oblique_pose(1), offsets_mm, 120);
  ContourConstraints made = signed_constraints(stack, sample_contours(stack, {}), {});
  const auto samples = static_cast<Eigen::Index>(made.samples.size());
  const Eigen::Matrix3Xd outwards = 7 * made.constraints.points.leftCols(samples);  // any length, any sign
  const double change = correct_for_oblique_cuts(outwards, stack, made);
  for (const ContourConstraints::Partner& partner : made.partners) {
    const double height = offsets_mm[made.samples[static_cast<std::size_t>(partner.sample)].slice];
    const double sine = std::sqrt(1 - std::pow(height / radius_mm, 2));
    EXPECT_NEAR(made.constraints.values[partner.constraint], sine * partner.in_plane_distance_mm, 1e-9);
  }
  EXPECT_NEAR(change, 1 - 0.6, 1e-9);  // z = 24 of 30: sin = 0.6
  EXPECT_NEAR(correct_for_oblique_cuts(-outwards, stack, made), 0, 1e-12) << "the correction does not add up";
}

TEST(ObliqueCuts, FirstOrderDistanceOfTheSphere) {
  const double radius_mm = 30, pixel_mm = 0.2;
  const ContourStack stack = sphere_cuts(radius_mm, oblique_pose(pixel_mm), {-18, 6}, 600);
  ContourConstraints made = signed_constraints(stack, sample_contours(stack, {}), {});
  correct_for_oblique_cuts(made.constraints.points.leftCols(static_cast<Eigen::Index>(made.samples.size())), stack,
                           made);
  for (Eigen::Index i = 0; i < made.constraints.values.size(); ++i) {
    const double truth = radius_mm - made.constraints.points.col(i).norm();
    EXPECT_NEAR(made.constraints.values[i], truth, pixel_mm * pixel_mm / radius_mm);  // second order in the offset
  }
}

TEST(ObliqueCuts, ATangentPlaneKeepsATenth) {
  const ContourStack stack = sphere_cuts(30, oblique_pose(1), {0}, 120);
  ContourConstraints made = signed_constraints(stack, sample_contours(stack, {}), {});
  const Eigen::Matrix3Xd across = oblique_pose(1).normal().replicate(1, static_cast<Eigen::Index>(made.samples.size()));
  EXPECT_NEAR(correct_for_oblique_cuts(across, stack, made), 0.9, 1e-12);
  const ContourConstraints::Partner& partner = made.partners.front();
  EXPECT_NEAR(made.constraints.values[partner.constraint], 0.1 * partner.in_plane_distance_mm, 1e-12);
}

TEST(AddPoints, AppendsAndLeavesTheRest) {
  const ContourStack stack = sphere_cuts(30, oblique_pose(1), {0}, 60);
  ContourConstraints made = signed_constraints(stack, sample_contours(stack, {}), {});
  const ConstraintSet before = made.constraints;
  add_points({{1, 2, 3}, {4, 5, 6}}, {-2, 3}, made);
  const Eigen::Index n = before.values.size();
  ASSERT_EQ(made.constraints.values.size(), n + 2);
  EXPECT_TRUE(made.constraints.points.leftCols(n) == before.points);
  EXPECT_TRUE(made.constraints.values.head(n) == before.values);
  EXPECT_EQ(made.constraints.values[n + 1], 3);
  EXPECT_TRUE(made.constraints.points.col(n).isApprox(Eigen::Vector3d(1, 2, 3)));
}

}  // namespace
}  // namespace isostack

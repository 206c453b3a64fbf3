#include "recon/constraints/soften.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/metrics/mesh_measures.h"
#include "recon/reconstruct.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::sphere_cuts;

constexpr double radius_mm = 30;

/// Two orthogonal stacks of a sphere, the second `shift_mm` along x from where it belongs.
ContourStack contradicting_stacks(double shift_mm) {
  const std::vector<double> offsets_mm = {-24, -16, -8, 0, 8, 16, 24};
  ContourStack stack = sphere_cuts(radius_mm, {}, offsets_mm, 120);
  SlicePose upright;
  upright.y_axis = -Eigen::Vector3d::UnitZ();
  for (ContourSlice& slice : sphere_cuts(radius_mm, upright, offsets_mm, 120).slices) {
    slice.pose.origin_mm.x() += shift_mm;
    slice.name = "upright " + slice.name;
    stack.slices.push_back(slice);
  }
  return stack;
}

TEST(Soften, TheFormulaHolds) {
  const std::vector<SoftPlace> places = {{{0, 0, 0}, {2, 0, 0}, 2}};
  Eigen::MatrixXd points(3, 4);
  points << 1, 1, 1, 50,  //
      0, 3, 6.1, 0,       //
      0, 0, 0, 0;
  const Eigen::VectorXd rho = softening_of(points, places, triharmonic(), {.strength = 10, .reach = 3});
  EXPECT_DOUBLE_EQ(rho[0], 80);                  // 10 · 2³
  EXPECT_NEAR(rho[1], 80 * 0.75 * 0.75, 1e-12);  // half the reach away
  EXPECT_EQ(rho[2], 0);
  EXPECT_EQ(rho[3], 0);
  EXPECT_DOUBLE_EQ(softening_of(points, places, biharmonic(), {.strength = 10})[0], 20);
}

TEST(Soften, OnlyContradictionsBeyondHalfAPixelCount) {
  EXPECT_TRUE(soft_places(find_contradictions(contradicting_stacks(0.4)), 1).empty());
  EXPECT_FALSE(soft_places(find_contradictions(contradicting_stacks(1.5)), 1).empty());
}

TEST(Soften, TheSurfacePassesBetweenContradictingStacks) {
  constexpr double shift_mm = 2;
  const ContourStack stack = contradicting_stacks(shift_mm);
  ReconstructOptions options;
  options.resolution_mm = 1.5;
  const Reconstruction soft = reconstruct(stack, options);
  EXPECT_GT(soft.report.softened_constraints, 500u);
  const MeshMeasures measures = measure(soft.surface);
  EXPECT_TRUE(measures.watertight());
  EXPECT_EQ(measures.components, 1u);
  EXPECT_EQ(measures.genus, 0);
  for (const Eigen::Vector3d& v : soft.surface.vertices_mm) {
    const double a = v.norm() - radius_mm, b = (v - Eigen::Vector3d(shift_mm, 0, 0)).norm() - radius_mm;
    EXPECT_LT(std::min(a, b), 1);  // outside both spheres: by less than half the contradiction
    EXPECT_GT(std::max(a, b), -1);
  }
  const double area_mm2 = 4 * std::numbers::pi * radius_mm * radius_mm;
  EXPECT_NEAR(measures.area_mm2, area_mm2, 0.04 * area_mm2);  // ripples add area

  options.softening.strength = 0;
  const Reconstruction hard = reconstruct(stack, options);
  EXPECT_EQ(hard.report.softened_constraints, 0u);
  EXPECT_GT(measure(hard.surface).area_mm2 - area_mm2, 2 * (measures.area_mm2 - area_mm2));
}

TEST(Soften, AgreeingSlicesAreMetExactly) {
  const Reconstruction r = reconstruct(contradicting_stacks(0), {});
  EXPECT_EQ(r.report.softened_constraints, 0u);
  EXPECT_LT(r.report.contradictions.largest_mismatch_mm(), 0.1);
}

}  // namespace
}  // namespace isostack

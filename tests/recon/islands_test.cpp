#include "recon/surface/islands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/metrics/mesh_measures.h"
#include "recon/reconstruct.h"
#include "recon/surface/plane_section.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

const Eigen::Vector3d speck_mm(20.7, 0.6, 0.4);
constexpr double speck_radius_mm = 0.4;

double ball_and_speck(const Eigen::Vector3d& p) {
  return std::max(10 - p.norm(), speck_radius_mm - (p - speck_mm).norm());
}

const ExtractionOptions coarse = {
    .resolution_mm = 2, .bounds = {Eigen::Vector3d(-12, -12, -12), Eigen::Vector3d(24, 12, 12)}, .half_spaces = {}};

Eigen::AlignedBox3d box_round(const Eigen::Vector3d& centre, double reach_mm) {
  return {centre.array() - reach_mm, centre.array() + reach_mm};
}

TEST(Islands, ABallBetweenTheCellsGetsCellsOfItsOwn) {
  const ScalarField field = testing_support::field_of(ball_and_speck);
  const Eigen::Vector3d seed = speck_mm + Eigen::Vector3d(speck_radius_mm, 0, 0);
  ExtractedSurface extracted = extract_surface(field, {{10, 0, 0}, seed}, coarse);
  ASSERT_EQ(extracted.seeds_without_surface, (std::vector<std::size_t>{1}));
  const auto island = extract_island(field, {seed}, box_round(speck_mm, 1), 0.05, coarse);
  ASSERT_TRUE(island.has_value());
  const double volume_mm3 = 4 * std::numbers::pi / 3 * std::pow(speck_radius_mm, 3);
  EXPECT_NEAR(measure(*island).volume_mm3 / volume_mm3, 1, 0.02);  // chords of 0.05 mm on 0.4 mm

  ASSERT_TRUE(add_island(*island, coarse.resolution_mm, extracted.mesh));
  const MeshMeasures both = measure(extracted.mesh);
  EXPECT_TRUE(both.watertight());
  EXPECT_EQ(both.components, 2u);
  EXPECT_EQ(extracted.mesh.normals.size(), extracted.mesh.vertices_mm.size());
  EXPECT_FALSE(add_island(*island, coarse.resolution_mm, extracted.mesh)) << "it is there already";
}

TEST(Islands, WhatGoesOnBeyondTheBoxIsNone) {
  const ScalarField field = testing_support::field_of(ball_and_speck);
  EXPECT_FALSE(extract_island(field, {{10, 0, 0}}, box_round({10, 0, 0}, 3), 0.5, coarse).has_value());
  EXPECT_FALSE(extract_island(field, {{0, 0, 0}}, box_round({0, 0, 0}, 3), 0.5, coarse).has_value());  // no surface
}

/// A body, and beside it on one slice a sheet that is wider than two pixels but thinner than the cells.
TEST(Islands, ASheetThinnerThanTheCellsIsReconstructed) {
  ContourStack stack{.name = "body and sheet", .slices = {}};
  for (int i = 0; i < 5; ++i) {
    ContourSlice slice{.name = "slice", .pose = {}, .contours = {testing_support::circle({0, 0}, 8, 80)}};
    slice.pose.origin_mm.z() = 2 * i;
    stack.slices.push_back(slice);
  }
  Contour sheet = testing_support::circle({0, 0}, 1, 24);
  for (Eigen::Vector2d& point : sheet.points_mm)
    point = Eigen::Vector2d(20.5 + 1.3 * point.x(), 0.5 + 0.15 * point.y());
  stack.slices[2].contours.push_back(sheet);
  const Reconstruction made = reconstruct(stack, {});
  EXPECT_EQ(made.report.contour_points_without_surface, 0u);
  EXPECT_EQ(made.report.sections.missed, 0u);
  EXPECT_EQ(made.report.resolution_mm, 1);  // the body keeps its cells
  const MeshMeasures measures = measure(made.surface);
  EXPECT_TRUE(measures.watertight());
  EXPECT_EQ(measures.components, 2u);
  EXPECT_EQ(plane_section(made.surface, stack.slices[2].pose).size(), 2u);
}

}  // namespace
}  // namespace isostack

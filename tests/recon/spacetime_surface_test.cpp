#include "recon/morphing/spacetime_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/blend_morph.h"
#include "recon/morphing/level_set_morph.h"
#include "recon/morphing/signed_distance_morph.h"
#include "recon/morphing/subdivision_morph.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::disc;

constexpr double first_radius_mm = 15, last_radius_mm = 30;

std::vector<KeyShape> two_discs() {
  return {disc("first", {50, 50}, first_radius_mm), disc("last", {50, 50}, last_radius_mm)};
}

SlicePose tilted() {
  SlicePose pose;
  pose.origin_mm = {10, -20, 300};
  pose.x_axis = {0.6, 0.8, 0};
  pose.y_axis = {0, 0, -1};
  return pose;
}

TEST(SpacetimeSurface, OfTwoDiscsIsTheSideOfACone) {
  const Morph morph = signed_distance_morph(two_discs(), {});
  const SlicePose pose = tilted();
  const auto surface = spacetime_surface(morph, pose);
  ASSERT_TRUE(surface.has_value());
  ASSERT_EQ(surface->normals.size(), surface->vertices_mm.size());
  const double length_mm = morph.report().spacing_mm;
  const double slant_mm = std::hypot(length_mm, last_radius_mm - first_radius_mm);
  const double area_mm2 = std::numbers::pi * (first_radius_mm + last_radius_mm) * slant_mm;
  EXPECT_NEAR(measure(*surface).area_mm2 / area_mm2, 1, 1e-3);  // cells of 1 mm on curves of 15 mm
  for (std::size_t i = 0; i < surface->vertices_mm.size(); ++i) {
    const Eigen::Vector3d from_axis = surface->vertices_mm[i] - pose.slice_to_world({50, 50});
    const double t = from_axis.dot(pose.normal()) / length_mm;
    ASSERT_NEAR(t, std::clamp(t, 0.0, 1.0), 1e-9);
    const Eigen::Vector3d radial = from_axis - t * length_mm * pose.normal();
    ASSERT_NEAR(radial.norm(), first_radius_mm + t * (last_radius_mm - first_radius_mm), 0.03);
    ASSERT_GT(surface->normals[i].dot(radial.normalized()), 0.5);
  }
}

TEST(SpacetimeSurface, IsOpenAtBothEndsOnly) {
  for (const Morph& morph : {signed_distance_morph(two_discs(), {}), variational_morph(two_discs(), {}),
                             blend_morph(two_discs(), {}), subdivision_morph(two_discs(), {})}) {
    SCOPED_TRACE(morph.report().method);
    const auto surface = spacetime_surface(morph, {});
    ASSERT_TRUE(surface.has_value());
    const MeshMeasures measures = measure(*surface);
    EXPECT_EQ(measures.components, 1u);
    EXPECT_EQ(measures.euler_characteristic, 0);  // an annulus
    EXPECT_EQ(measures.flipped_edges, 0u);
    EXPECT_EQ(measures.non_manifold_edges, 0u);
    EXPECT_GT(measures.volume_mm3, 0);
  }
}

TEST(SpacetimeSurface, ALevelSetMorphHasNone) {
  EXPECT_FALSE(spacetime_surface(level_set_morph(two_discs(), {}), {}).has_value());
}

TEST(SpacetimeSlices, AreAsFarAlongTheNormalAsTheyAreInTheMorph) {
  const Morph morph = signed_distance_morph(two_discs(), {});
  std::vector<ContourSlice> figures;
  std::vector<Eigen::VectorXd> weights;
  for (const double t : {0.25, 0.5, 1.0}) {
    figures.push_back(std::get<ContourSlice>(morph.shape_at(t)));
    figures.back().pose = tilted();
    weights.push_back(morph.places().weights_at(t));
  }
  const ContourStack stack = spacetime_slices(morph, figures, weights);
  ASSERT_EQ(stack.slices.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d way = stack.slices[i].pose.origin_mm - tilted().origin_mm;
    const double share = i == 2 ? 1 : 0.25 * static_cast<double>(i + 1);
    EXPECT_LT((way - share * morph.report().spacing_mm * tilted().normal()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace isostack

#include "recon/section_repairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;
using testing_support::sphere_mesh;

/// Facets of this sphere of radius 20 mm are 0.003 mm below it at most: 20 · (1 − cos(π / 200)) and less.
TriangleMesh fine_sphere() { return sphere_mesh(Eigen::Vector3d::Zero(), 20, 400, 200); }

TEST(SectionDeviations, ExactContoursAreNotMissed) {
  const SectionDeviations found = section_deviations(fine_sphere(), sphere_cuts(20, {}, {-15, -5, 5, 15}, 400), 0.1);
  EXPECT_TRUE(found.empty());
  EXPECT_LT(found.mean_pixels, 0.01);  // facets and chords of 0.003 mm each, pixels of 1 mm
}

TEST(SectionDeviations, TheyAreMeasuredBothWaysInMillimetres) {
  ContourStack cuts = sphere_cuts(20, {}, {0}, 400);
  cuts.slices[0].pose.spacing_mm = {2, 2};
  cuts.slices[0].contours = {circle({0, 0}, 18, 400)};
  EXPECT_TRUE(section_deviations(fine_sphere(), cuts, 1.1).empty());  // 2 mm are one pixel
  const SectionDeviations found = section_deviations(fine_sphere(), cuts, 0.9);
  ASSERT_FALSE(found.missed.empty());
  ASSERT_EQ(found.missed.size(), found.missed_by_mm.size());
  EXPECT_NEAR(found.mean_pixels, 1, 0.01);
  for (std::size_t i = 0; i < found.missed.size(); ++i) {
    EXPECT_NEAR(found.missed_by_mm[i], 2, 0.01);
    const Eigen::Vector2d& p = found.missed[i].point_in_slice_mm;
    EXPECT_GT(found.missed[i].inward.dot(-p.normalized()), 0.99);
  }
  for (const StrayPoint& stray : found.stray) EXPECT_NEAR(stray.distance_mm, -2, 0.01);  // outside the contour
  EXPECT_GE(static_cast<double>(found.stray.size()), 2 * M_PI * 20 / 0.5);               // every quarter of a pixel
}

TEST(SectionDeviations, PlanesThatOnlyOneSideKnows) {
  ContourStack cuts = sphere_cuts(20, {}, {0, 30}, 400);
  cuts.slices[0].contours.clear();                    // the surface is there, the organ is not
  cuts.slices[1].contours = {circle({0, 0}, 5, 40)};  // and the other way round
  const SectionDeviations found = section_deviations(fine_sphere(), cuts, 0.25);
  ASSERT_FALSE(found.stray.empty());
  for (const StrayPoint& stray : found.stray) {
    EXPECT_EQ(stray.slice, 0u);
    EXPECT_EQ(stray.distance_mm, -1);
  }
  ASSERT_FALSE(found.missed.empty());
  for (std::size_t i = 0; i < found.missed.size(); ++i) {
    EXPECT_EQ(found.missed[i].slice, 1u);
    EXPECT_TRUE(std::isinf(found.missed_by_mm[i]));
  }
}

TEST(FarthestStrays, FarthestFirstAndSpreadOut) {
  std::vector<StrayPoint> strays;
  for (int i = 0; i <= 100; ++i) strays.push_back({0, {0.1 * i, 0}, i == 50 ? -4.0 : 1.0});
  const std::vector<StrayPoint> chosen = farthest_strays(strays, 0.7, 100);
  ASSERT_FALSE(chosen.empty());
  EXPECT_EQ(chosen.front().distance_mm, -4);
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    EXPECT_GE(std::abs(chosen[i].point_in_slice_mm.x() - 5), 2 - 1e-9);  // half of the farthest's distance
    for (std::size_t k = 1; k < i; ++k)
      EXPECT_GE((chosen[i].point_in_slice_mm - chosen[k].point_in_slice_mm).norm(), 0.7 - 1e-9);
  }
  EXPECT_EQ(farthest_strays(strays, 0.7, 3).size(), 3u);
}

TEST(FarthestStrays, PointsOfOtherSlicesDoNotCount) {
  EXPECT_EQ(farthest_strays({{0, {0, 0}, 1}, {1, {0, 0}, 1}, {0, {0.1, 0}, 1}}, 0.5, 10).size(), 2u);
}

}  // namespace
}  // namespace isostack

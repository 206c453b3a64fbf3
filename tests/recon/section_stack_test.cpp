#include "recon/surface/section_stack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

TEST(SectionStack, ASphereComesBackAsItsCirclesOnEveryPlane) {
  const Eigen::Vector3d centre(10, -5, 20);
  constexpr double radius_mm = 12;
  std::vector<ContourSlice> planes;
  for (int i = 0; i < 11; ++i) {
    ContourSlice& plane = planes.emplace_back();
    plane.name = "plane " + std::to_string(i);
    plane.pose.origin_mm = {-20, -40, 5.5 + 3 * i};
    plane.size_pixels = {64, 48};
  }
  const TriangleMesh sphere = testing_support::sphere_mesh(centre, radius_mm, 240, 160);
  const ContourStack stack = section_stack(sphere, planes, "ball");
  EXPECT_EQ(stack.name, "ball");
  ASSERT_EQ(stack.slices.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(stack.slices[i].name, planes[i].name);
    EXPECT_EQ(stack.slices[i].size_pixels, planes[i].size_pixels);
    const double height_mm = planes[i].pose.origin_mm.z() - centre.z();
    if (std::abs(height_mm) >= radius_mm) {
      EXPECT_TRUE(stack.slices[i].contours.empty());
      continue;
    }
    ASSERT_EQ(stack.slices[i].contours.size(), 1u);
    const double expected_mm2 = std::numbers::pi * (radius_mm * radius_mm - height_mm * height_mm);
    // Chords of 240 x 160 facets lie up to 0.03 mm inside.
    EXPECT_NEAR(signed_area_mm2(stack.slices[i].contours[0]), expected_mm2, 0.03 * 2 * std::numbers::pi * radius_mm);
  }
}

TEST(SectionStack, AnOpenSurfaceIsRefused) {
  TriangleMesh open = testing_support::sphere_mesh({0, 0, 0}, 5, 20, 10);
  open.name = "cup";
  open.triangles.pop_back();
  try {
    section_stack(open, std::vector<ContourSlice>(1));
    FAIL() << "no error";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("cup: the surface is not closed"), std::string::npos);
  }
}

}  // namespace
}  // namespace isostack

// Contours that the extracted surface misses.
#include "recon/organ_surface.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;

/// A sphere of radius 20 mm and on two of its slices a thin rod beside it.
ContourStack sphere_and_rod(double rod_radius_mm) {
  ContourStack cuts = sphere_cuts(20, {}, {-16, -8, 0, 8, 16}, 160);
  for (const std::size_t slice : {2u, 3u}) cuts.slices[slice].contours.push_back(circle({40, 3}, rod_radius_mm, 24));
  return cuts;
}

/// Cells between whose corners the rod fits.
ReconstructOptions coarse() {
  ReconstructOptions options;
  options.resolution_mm = 9;
  options.section_rounds = 0;
  return options;
}

TEST(ContoursWithoutSurface, AreFoundByFinerCells) {
  const Reconstruction r = reconstruct(sphere_and_rod(1.2), {});
  EXPECT_EQ(measure(r.surface).components, 2u);
  EXPECT_EQ(r.report.contour_points_without_surface, 0u);
}

TEST(ContoursWithoutSurface, AreAnErrorThatNamesTheSlice) {
  ReconstructOptions options = coarse();
  try {
    reconstruct(sphere_and_rod(1.2), options);
    FAIL() << "the rod is lost and nobody says so";
  } catch (const SolveError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("z = "), std::string::npos) << message;
    EXPECT_NE(message.find("--resolution"), std::string::npos) << message;
  }
  options.accept_lost_contours = true;
  const Reconstruction r = reconstruct(sphere_and_rod(1.2), options);
  EXPECT_GT(r.report.contour_points_without_surface, 0u);
  EXPECT_EQ(measure(r.surface).components, 1u);
}

TEST(ContoursWithoutSurface, SpecksAreCountedNotFatal) {
  const Reconstruction r = reconstruct(sphere_and_rod(0.5), coarse());  // one pixel wide
  EXPECT_GT(r.report.contour_points_without_surface, 0u);
  EXPECT_EQ(measure(r.surface).components, 1u);
}

}  // namespace
}  // namespace isostack

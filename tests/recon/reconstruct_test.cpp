#include "recon/reconstruct.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;

std::vector<double> every_8_mm() { return {-32, -24, -16, -8, 0, 8, 16, 24, 32}; }

TEST(Reconstruct, SphereFromNineSlices) {
  const ContourStack cuts = sphere_cuts(40, {}, every_8_mm(), 200);
  const Reconstruction r = reconstruct(cuts, {});
  const MeshMeasures m = measure(r.surface);
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.genus, 0);
  const double volume = 4.0 / 3 * std::numbers::pi * 64000, area = 4 * std::numbers::pi * 1600;
  EXPECT_NEAR(m.volume_mm3, volume, 0.005 * volume);
  EXPECT_NEAR(m.area_mm2, area, 0.01 * area);
  for (const Eigen::Vector3d& v : r.surface.vertices_mm)
    if (std::abs(v.z()) <= 32) {
      EXPECT_NEAR(v.norm(), 40, 0.3);
    }
}

TEST(Reconstruct, ObliqueSlicesGiveTheSameSphere) {
  SlicePose pose;
  pose.x_axis = Eigen::Vector3d(0.6, 0.8, 0).normalized();
  pose.y_axis = Eigen::Vector3d(-0.8 * 0.6, 0.6 * 0.6, 0.8).normalized();
  pose.origin_mm = {-70, 20, 10};
  pose.origin_mm += pose.signed_distance_mm(Eigen::Vector3d::Zero()) * pose.normal();  // its plane meets the centre
  const ContourStack cuts = sphere_cuts(40, pose, every_8_mm(), 200);
  const Reconstruction r = reconstruct(cuts, {});
  const double volume = 4.0 / 3 * std::numbers::pi * 64000;
  EXPECT_NEAR(measure(r.surface).volume_mm3, volume, 0.005 * volume);
  for (const Eigen::Vector3d& v : r.surface.vertices_mm)
    if (std::abs(v.dot(pose.normal())) <= 32) {
      EXPECT_NEAR(v.norm(), 40, 0.3);
    }
}

TEST(Reconstruct, TorusFromSlicesHasGenusOne) {
  // Ring radius 30, tube 12, cut across its axis: annuli.
  ContourStack cuts{.name = "torus", .slices = {}};
  for (double z = -10; z <= 10; z += 4) {
    ContourSlice slice{.name = "slice", .pose = {}, .contours = {}};
    slice.pose.origin_mm.z() = z;
    const double half_width = std::sqrt(144 - z * z);
    slice.contours.push_back(circle({0, 0}, 30 + half_width, 200));
    slice.contours.push_back(circle({0, 0}, 30 - half_width, 100, true));
    cuts.slices.push_back(slice);
  }
  const MeshMeasures m = measure(reconstruct(cuts, {}).surface);
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.genus, 1);
  const double volume = 2 * std::numbers::pi * std::numbers::pi * 30 * 144;
  EXPECT_NEAR(m.volume_mm3, volume, 0.02 * volume);  // the caps (|z| > 10 of 12) are extrapolated
}

TEST(Reconstruct, KeptContourPointsLieOnTheSurface) {
  const Reconstruction r = reconstruct(sphere_cuts(40, {}, every_8_mm(), 400), {});
  for (const double distance : distances_to_mesh_mm(r.kept_points_mm, r.surface)) EXPECT_LT(distance, 0.1);
  EXPECT_LE(r.report.largest_residual, r.report.tolerance);
}

TEST(Reconstruct, AnEmptySliceEndsTheSurfaceHalfWay) {
  // A cylinder of radius 20 seen on z = 0…40, absent on z = -10 and z = 50.
  ContourStack cuts{.name = "cylinder", .slices = {}};
  for (double z = -10; z <= 50; z += 10) {
    ContourSlice slice{.name = "slice", .pose = {}, .contours = {}};
    slice.pose.origin_mm.z() = z;
    if (z >= 0 && z <= 40) slice.contours.push_back(circle({0, 0}, 20, 120));
    cuts.slices.push_back(slice);
  }
  const Reconstruction r = reconstruct(cuts, {});
  EXPECT_TRUE(measure(r.surface).watertight());
  EXPECT_EQ(measure(r.surface).components, 1u);
  for (const Eigen::Vector3d& v : r.surface.vertices_mm) {
    EXPECT_GT(v.z(), -10);
    EXPECT_LT(v.z(), 50);
  }
}

TEST(Reconstruct, OneSliceIsRefused) { EXPECT_THROW(reconstruct(sphere_cuts(40, {}, {0.0}, 100), {}), GeometryError); }

}  // namespace
}  // namespace isostack

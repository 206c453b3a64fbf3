#include "recon/surface/stack_caps.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/reconstruct.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::sphere_cuts;

/// A cylinder of radius 20 seen on z = 0, 5, … 40; `empty_beyond` adds slices without it.
ContourStack cylinder(bool empty_beyond = false) {
  ContourStack cuts{.name = "cylinder", .slices = {}};
  for (int i = empty_beyond ? -1 : 0; i <= (empty_beyond ? 9 : 8); ++i) {
    ContourSlice slice{.name = "slice", .pose = {}, .contours = {}};
    slice.pose.origin_mm.z() = 5.0 * i;
    if (i >= 0 && i <= 8) slice.contours.push_back(circle({3, -2}, 20, 60));
    cuts.slices.push_back(slice);
  }
  return cuts;
}

constexpr double disc_mm2 = std::numbers::pi * 400;

std::pair<double, double> heights_of(const TriangleMesh& mesh) {
  double low = 1e9, high = -1e9;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) low = std::min(low, v.z()), high = std::max(high, v.z());
  return {low, high};
}

TEST(StackCaps, FlatCylinderEndsHalfAGapOutside) {
  for (const bool empty_beyond : {false, true}) {
    const Reconstruction r = reconstruct(cylinder(empty_beyond), {.caps = Caps::flat});
    const MeshMeasures m = measure(r.surface);
    EXPECT_TRUE(m.watertight());
    EXPECT_NEAR(m.volume_mm3, disc_mm2 * 45, 0.01 * disc_mm2 * 45);
    EXPECT_NEAR(m.area_mm2, 2 * disc_mm2 + 40 * std::numbers::pi * 45, 0.02 * m.area_mm2);  // edges are bevelled
    EXPECT_NEAR(heights_of(r.surface).first, -2.5, 1e-3);  // root finding: 1e-4 of a cell
    EXPECT_NEAR(heights_of(r.surface).second, 42.5, 1e-3);
  }
}

TEST(StackCaps, FlatLidsHaveTheLidsNormal) {
  const TriangleMesh mesh = reconstruct(cylinder(), {.caps = Caps::flat}).surface;
  int on_lid = 0;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    if ((mesh.vertices_mm[i] - Eigen::Vector3d(3, -2, 42.5)).norm() > 15) continue;
    EXPECT_GT(mesh.normals[i].z(), 0.999);
    ++on_lid;
  }
  EXPECT_GT(on_lid, 100);
}

TEST(StackCaps, OpenCylinderHasTwoRimsInTheOutermostSlices) {
  for (const bool empty_beyond : {false, true}) {
    const Reconstruction r = reconstruct(cylinder(empty_beyond), {.caps = Caps::open});
    const MeshMeasures m = measure(r.surface);
    EXPECT_FALSE(m.watertight());
    EXPECT_EQ(m.components, 1u);
    EXPECT_EQ(m.euler_characteristic, 0);  // a tube
    EXPECT_EQ(m.non_manifold_edges + m.flipped_edges, 0u);
    EXPECT_GT(m.boundary_edges, 100u);
    EXPECT_NEAR(heights_of(r.surface).first, 0, 1e-9);
    EXPECT_NEAR(heights_of(r.surface).second, 40, 1e-9);
    EXPECT_NEAR(m.area_mm2, 40 * std::numbers::pi * 40, 0.01 * m.area_mm2);  // no lid
  }
}

TEST(StackCaps, FlatSphereIsItsSlabAndTwoExtrudedDiscs) {
  // Radius 40 on z = -32 … 32 step 8: the slab is closed-form, beyond it discs of radius 24, 4 mm high.
  const Reconstruction r =
      reconstruct(sphere_cuts(40, {}, {-32, -24, -16, -8, 0, 8, 16, 24, 32}, 100), {.caps = Caps::flat});
  const double slab = 2 * std::numbers::pi * (1600.0 * 32 - 32.0 * 32 * 32 / 3);
  const double discs = 2 * std::numbers::pi * 24 * 24 * 4;
  EXPECT_NEAR(measure(r.surface).volume_mm3, slab + discs, 0.01 * (slab + discs));
  EXPECT_NEAR(heights_of(r.surface).second, 36, 1e-3);
}

TEST(StackCaps, CrossingSlicesHaveNoOutermostOne) {
  ContourStack cuts = sphere_cuts(40, {}, {-8, 0, 8}, 60);
  const SlicePose upright{.x_axis = Eigen::Vector3d::UnitY(), .y_axis = Eigen::Vector3d::UnitZ()};
  for (const ContourSlice& slice : sphere_cuts(40, upright, {-8, 8}, 60).slices) cuts.slices.push_back(slice);
  EXPECT_THROW(reconstruct(cuts, {.caps = Caps::flat}), GeometryError);
  EXPECT_THROW(reconstruct(cuts, {.caps = Caps::open}), GeometryError);
}

TEST(StackCaps, ClippedAtAVertexMakesNoThinTriangles) {
  TriangleMesh tent;
  tent.vertices_mm = {{0, 0, 0}, {1, 0, -1}, {1, 0, 1}, {2, 0, 0}};
  tent.triangles = {{0, 1, 2}, {2, 1, 3}};
  const TriangleMesh upper = clipped(tent, {Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitZ(), 0.0)});
  EXPECT_EQ(upper.triangles.size(), 2u);
  EXPECT_EQ(upper.vertices_mm.size(), 4u);  // 0, 2, 3 and the cut of edge 1–2
  EXPECT_NEAR(measure(upper).area_mm2, 1, 1e-12);
}

}  // namespace
}  // namespace isostack

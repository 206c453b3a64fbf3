#include "recon/surface/extract_surface.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::field_of;
using testing_support::sphere_mm;
using testing_support::torus_mm;

ExtractionOptions options_within(double half_size_mm, double resolution_mm) {
  ExtractionOptions options;
  options.resolution_mm = resolution_mm;
  options.bounds =
      Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-half_size_mm), Eigen::Vector3d::Constant(half_size_mm));
  return options;
}

TEST(ExtractSurface, SphereIsClosedAndItsVerticesLieOnIt) {
  const auto field = field_of([](const Eigen::Vector3d& p) { return sphere_mm(p, 20); });
  const TriangleMesh mesh = extract_surface(field, {{20, 0, 0}}, options_within(30, 1)).mesh;
  const MeshMeasures m = measure(mesh);
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.genus, 0);
  for (const Eigen::Vector3d& v : mesh.vertices_mm) EXPECT_NEAR(v.norm(), 20, 1e-3);  // the root tolerance allows 1e-4
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    EXPECT_GT(mesh.normals[i].dot(mesh.vertices_mm[i].normalized()), 0.999);
  // Chords of 1 mm cells lie below the sphere by at most h²/8r = 0.6 % of a mm: 0.1 % of the volume.
  const double volume = 4.0 / 3 * std::numbers::pi * 8000;
  EXPECT_NEAR(m.volume_mm3, volume, 0.002 * volume);
  EXPECT_GT(m.volume_mm3, 0) << "faces must point outwards";
}

TEST(ExtractSurface, TorusHasGenusOne) {
  const auto field = field_of([](const Eigen::Vector3d& p) { return torus_mm(p, 20, 7); });
  const MeshMeasures m = measure(extract_surface(field, {{27, 0, 0}}, options_within(40, 1.3)).mesh);
  EXPECT_TRUE(m.watertight());
  EXPECT_EQ(m.genus, 1);
}

TEST(ExtractSurface, AValueOfExactlyZeroAtNodesKeepsTheSurfaceManifold) {
  // A box whose faces pass exactly through lattice nodes.
  const auto field = field_of([](const Eigen::Vector3d& p) { return 10 - p.lpNorm<Eigen::Infinity>(); });
  const MeshMeasures m = measure(extract_surface(field, {{10, 0, 0}}, options_within(20, 1)).mesh);
  EXPECT_TRUE(m.watertight());
  EXPECT_NEAR(m.volume_mm3, 8000, 0.01 * 8000);  // edges and corners are cut by up to one cell
}

TEST(ExtractSurface, WildFieldsStayManifold) {
  // Near-random signs from node to node exercise every ambiguous face.
  const auto field = field_of([](const Eigen::Vector3d& p) {
    return std::sin(3.1 * p.x() + p.y()) * std::cos(2.7 * p.y() - p.z()) + 0.4 * std::sin(2.9 * p.z() + 0.7 * p.x());
  });
  const ExtractedSurface surface = extract_surface(field, {{0.3, 0.1, 0.2}}, options_within(8, 0.8));
  EXPECT_TRUE(surface.cut_by_bounds);
  const MeshMeasures m = measure(surface.mesh);
  EXPECT_GT(m.triangles, 1000u);
  EXPECT_TRUE(m.watertight()) << m.boundary_edges << " " << m.non_manifold_edges << " " << m.flipped_edges;
}

TEST(ExtractSurface, OnlyComponentsAtSeedsAreFollowed) {
  const auto field = field_of([](const Eigen::Vector3d& p) {
    return std::max(sphere_mm(p - Eigen::Vector3d(15, 0, 0), 8), sphere_mm(p + Eigen::Vector3d(15, 0, 0), 8));
  });
  const ExtractedSurface one = extract_surface(field, {{23, 0, 0}}, options_within(30, 1));
  EXPECT_EQ(measure(one.mesh).components, 1u);
  EXPECT_FALSE(one.cut_by_bounds);
  EXPECT_EQ(measure(extract_surface(field, {{23, 0, 0}, {-23, 0, 0}}, options_within(30, 1)).mesh).components, 2u);
}

TEST(ExtractSurface, AnUnboundedSurfaceIsClosedAtTheBox) {
  const auto cylinder = field_of([](const Eigen::Vector3d& p) { return 5 - std::hypot(p.x(), p.y()); });
  const ExtractedSurface surface = extract_surface(cylinder, {{5, 0, 0}}, options_within(12, 0.5));
  EXPECT_TRUE(surface.cut_by_bounds);
  const MeshMeasures m = measure(surface.mesh);
  EXPECT_TRUE(m.watertight());
  const double volume = std::numbers::pi * 25 * 24;
  EXPECT_NEAR(m.volume_mm3, volume, 0.02 * volume);  // rims are chamfered within one 0.5 mm cell
}

TEST(ExtractSurface, NoSurfaceIsAnErrorUnlessItMayBe) {
  const ScalarField ball = field_of([](const Eigen::Vector3d& p) { return sphere_mm(p, 3); });
  ExtractionOptions options = options_within(12, 0.5);
  EXPECT_THROW(extract_surface(ball, {{10, 10, 10}}, options), GeometryError);
  options.may_be_empty = true;
  EXPECT_TRUE(extract_surface(ball, {{10, 10, 10}}, options).mesh.triangles.empty());
  EXPECT_TRUE(extract_surface(ball, {}, options).mesh.vertices_mm.empty());
}

}  // namespace
}  // namespace isostack

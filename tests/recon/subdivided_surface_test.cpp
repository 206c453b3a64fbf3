#include "recon/subdivision/subdivided_surface.h"

#include <gtest/gtest.h>

#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/mesh_quality.h"
#include "recon/subdivision/base_mesh.h"
#include "recon/subdivision/surface_map.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;
using testing_support::torus_mesh;

SubdividedSurface subdivided_sphere(int levels) {
  const TriangleMesh mesh = sphere_mesh({1, 2, 3}, 30, 60, 40);
  return subdivided(mesh, spread_over_domain(mesh), sphere_base({}), levels);
}

TEST(SubdividedSurface, SphereStaysAnEvenSphere) {
  const SubdividedSurface surface = subdivided_sphere(4);
  const TriangleMesh mesh = surface.mesh();
  EXPECT_EQ(mesh.triangles.size(), 20u << 8);
  const MeshMeasures measures = measure(mesh);
  EXPECT_TRUE(measures.watertight());
  EXPECT_EQ(measures.euler_characteristic, 2);
  // The given mesh's facets are up to 0.1 mm within the sphere.
  for (const Eigen::Vector3d& p : mesh.vertices_mm) EXPECT_NEAR((p - Eigen::Vector3d(1, 2, 3)).norm(), 30, 0.15);
  const MeshQuality quality = measure_quality(mesh);
  // An icosahedron halved on the sphere has edges that differ by a factor of 1.2 and angles of 53° to 72°.
  EXPECT_LT(quality.longest_edge_mm, 1.6 * quality.shortest_edge_mm);
  EXPECT_GT(quality.mean_smallest_angle_deg, 52);
}

TEST(SubdividedSurface, ComesNearerToTheSurfaceByLevels) {
  const TriangleMesh mesh = torus_mesh(28, 11, 60, 30);
  const DomainMesh drawn = spread_over_domain(mesh);
  DomainMesh base = torus_base({6, 4});
  // The same torus by the base's periods.
  DomainMesh aligned = drawn;
  const Eigen::Matrix2d linear = base.domain.periods.topRows<2>() * drawn.domain.periods.topRows<2>().inverse();
  if (linear.determinant() < 0) GTEST_FAIL() << "periods are counter-clockwise";
  for (Eigen::Vector3d& p : aligned.positions) p.head<2>() = (linear * p.head<2>()).eval();
  aligned.domain = base.domain;
  double before = 100;
  for (int levels = 1; levels <= 4; ++levels) {
    const SubdividedSurface surface = subdivided(mesh, aligned, base, levels);
    EXPECT_EQ(measure(surface.mesh()).euler_characteristic, 0);
    const double fit = fit_of(surface, mesh).mean_mm;
    EXPECT_LT(fit, before / 2);  // chords of a smooth surface: a quarter, until its own facets show
    before = fit;
  }
}

TEST(SubdividedSurface, DetailsComeBackWithoutLoss) {
  const SubdividedSurface surface = subdivided_sphere(3);
  const std::vector<Eigen::Matrix3Xd> details = details_of(surface);
  ASSERT_EQ(details.size(), 3u);
  const Eigen::Matrix3Xd again =
      with_details(surface.levels, surface.places_mm.leftCols(surface.levels.base_vertex_count), details);
  EXPECT_LT((again - surface.places_mm).cwiseAbs().maxCoeff(), 1e-12);  // rounding at 40 mm
  // Middles of chords lie inside the sphere, the less the finer: details fall by a factor of four.
  const auto mean = [](const Eigen::Matrix3Xd& d) { return d.colwise().norm().mean(); };
  EXPECT_NEAR(mean(details[1]) / mean(details[2]), 4, 0.4);
}

}  // namespace
}  // namespace isostack

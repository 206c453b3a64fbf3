#include "recon/subdivision/domain_alignment.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "recon/subdivision/domain_features.h"
#include "recon/subdivision/surface_map.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using testing_support::moved;
using testing_support::sphere_mesh;
using testing_support::torus_mesh;

/// An egg with a nose: it looks the same from no two sides.
TriangleMesh egg() {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 1, 30, 24);
  for (Eigen::Vector3d& p : mesh.vertices_mm) {
    const double nose = 1 + 0.5 * std::exp(-8 * (p - Eigen::Vector3d(0.8, 0, 0.6)).squaredNorm());
    p = Eigen::Vector3d(24 * p.x(), 30 * p.y(), p.z() > 0 ? 50 * p.z() : 34 * p.z()) * nose;
  }
  return mesh;
}

/// Mean distance of a shape's own vertices from the places that their places on the domain have on the other.
double mean_distance(const TriangleMesh& first, const TriangleMesh& second, const AlignedDomains& domains) {
  const Eigen::Matrix3Xd there = places_on(second, domains.drawn[1], domains.drawn[0].positions);
  double sum = 0;
  for (std::size_t v = 0; v < first.vertices_mm.size(); ++v)
    sum += (there.col(static_cast<Eigen::Index>(v)) - first.vertices_mm[v]).norm();
  return sum / static_cast<double>(first.vertices_mm.size());
}

/// The same shape, drawn on a domain turned away: aligned it lies on itself.
TEST(DomainAlignment, TurnsASphereBack) {
  const TriangleMesh mesh = egg();
  const DomainMesh drawn = spread_over_domain(mesh);
  DomainMesh turned = drawn;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (Eigen::Vector3d& p : turned.positions) p = turn * p;
  // Turned in steps down to half a degree: 0.4 mm at a radius of 50 mm.
  EXPECT_LT(mean_distance(mesh, mesh, aligned({&mesh, &mesh}, {drawn, turned})), 0.5);
}

TEST(DomainAlignment, SizeAndPlaceDoNotMatter) {
  const TriangleMesh mesh = egg();
  TriangleMesh larger = mesh;
  for (Eigen::Vector3d& p : larger.vertices_mm) p = 3 * p + Eigen::Vector3d(200, -100, 50);
  const DomainMesh drawn = spread_over_domain(mesh);
  const AlignedDomains domains = aligned({&mesh, &larger}, {drawn, drawn});
  EXPECT_LT(mean_distance(larger, larger, {{domains.drawn[0], domains.drawn[1]}, {}}), 1.5);  // half a degree
}

/// Round the ring and round the tube must not be mistaken for each other.
TEST(DomainAlignment, MatchesATorusByRingAndTube) {
  const TriangleMesh first = torus_mesh(28, 11, 48, 24), second = torus_mesh(30, 8, 40, 20);
  const AlignedDomains domains = aligned({&first, &second}, {spread_over_domain(first), spread_over_domain(second)});
  // The tubes' surfaces are 2 to 5 mm apart; the tables are steps of 3 to 6 mm.
  EXPECT_LT(mean_distance(first, second, domains), 10);
}

TEST(DomainFeatures, CornersComeToTheirPlaces) {
  const TriangleMesh mesh = egg();
  const DomainMesh drawn = spread_over_domain(mesh);
  const std::vector<PulledVertex> wanted{
      {10, drawn.positions[60]}, {400, drawn.positions[550]}, {200, -drawn.positions[200]}};
  const DomainMesh after = pulled(mesh, drawn, wanted);
  for (const PulledVertex& one : wanted)
    EXPECT_LT((after.positions[static_cast<std::size_t>(one.vertex)] - one.target).norm(), 1e-12);
  for (int t = 0; t < static_cast<int>(after.triangles.size()); ++t)
    EXPECT_GT(SurfaceDomain::orientation(after.corner(t, 0, 0), after.corner(t, 1, 0), after.corner(t, 2, 0)), 0);
}

}  // namespace
}  // namespace isostack

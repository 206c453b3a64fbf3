#include "recon/subdivision/surface_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/subdivision/stretch.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/obj_mesh.h"

namespace isostack {
namespace {

using testing_support::box_mesh;
using testing_support::obj_mesh;
using testing_support::sphere_mesh;
using testing_support::torus_mesh;

/// A sphere with a long arm, which is not star-shaped: it bends round.
TriangleMesh bent_arm() {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 1, 40, 60);
  for (Eigen::Vector3d& p : mesh.vertices_mm) {
    const double along = 3 * (p.z() + 1), angle = along / 2;
    const Eigen::Vector3d across(p.x() * 0.4, p.y() * 0.4, 0);
    p = {2 * std::cos(angle) + across.x() * std::cos(angle), across.y(),
         2 * std::sin(angle) + across.x() * std::sin(angle)};
  }
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Solid angles, or areas: the triangles cover the domain once, none turned over.
double covered_share(const DomainMesh& drawn) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(drawn.triangles.size()); ++t) {
    const Eigen::Vector3d p = drawn.corner(t, 0, 0), q = drawn.corner(t, 1, 0), r = drawn.corner(t, 2, 0);
    const double area = SurfaceDomain::orientation(p, q, r);
    EXPECT_GT(area, 0) << "triangle " << t;
    sum += drawn.domain.genus == 0 ? 2 * std::atan2(area, 1 + p.dot(q) + q.dot(r) + r.dot(p)) : area / 2;
  }
  const double whole = drawn.domain.genus == 0
                           ? 4 * std::numbers::pi
                           : std::abs(drawn.domain.periods.col(0).cross(drawn.domain.periods.col(1)).z());
  return sum / whole;
}

/// Of the surface's area, the share that gets less than this part of the domain it should get.
double undersampled(const TriangleMesh& mesh, const DomainMesh& drawn, double part) {
  double area = 0, share = 0, few = 0;
  const auto surface_area = [&](std::size_t t) {
    const auto p = [&](int c) { return mesh.vertices_mm[static_cast<std::size_t>(mesh.triangles[t][c])]; };
    return (p(1) - p(0)).cross(p(2) - p(0)).norm();
  };
  const auto domain_area = [&](std::size_t t) {
    const int i = static_cast<int>(t);
    return SurfaceDomain::orientation(drawn.corner(i, 0, 0), drawn.corner(i, 1, 0), drawn.corner(i, 2, 0));
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area += surface_area(t);
    share += domain_area(t);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (domain_area(t) / share < part * surface_area(t) / area) few += surface_area(t) / area;
  return few;
}

TEST(Stretch, GradientIsTheDerivative) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  const auto near = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x() + uniform(random), p.y() + uniform(random), p.z() + uniform(random));
  };
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = near({1, 0, 1}), q = near({0, 1, 1}), r = near({-1, -0.5, 1});
    const SurfaceTriangle surface = surface_triangle(near({0, 0, 0}), near({2, 0, 0}), near({0, 3, 1}));
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    add_stretch_gradient(surface, p, q, r, gradient);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(axis);
      const double difference = (stretch(surface, p + step, q, r) - stretch(surface, p - step, q, r)) / 2e-5;
      // Central differences of a function with derivatives of its own size are off by some 1e-10 of it.
      EXPECT_NEAR(gradient[axis], difference, 1e-6 * (1 + gradient.norm()));
    }
  }
}

TEST(SurfaceMap, CoversTheDomainOnceWhateverTheShape) {
  for (const TriangleMesh& mesh : {box_mesh({0, 0, 0}, {1, 2, 30}), sphere_mesh({5, 5, 5}, 2, 30, 20), bent_arm(),
                                   torus_mesh(28, 11, 40, 16), torus_mesh(30, 2, 90, 6)})
    EXPECT_NEAR(covered_share(spread_over_domain(mesh)), 1, 1e-9) << mesh.name;  // rounding of some 1e4 areas
}

TEST(SurfaceMap, SphereIsSpreadEvenly) {
  const TriangleMesh mesh = sphere_mesh({0, 0, 0}, 30, 40, 30);
  EXPECT_EQ(undersampled(mesh, spread_over_domain(mesh), 0.9), 0);  // the even map is the identity: 1 everywhere
}

/// A conformal map would shrink the arm's far end by e^(-arm length / radius), some 1/2000.
TEST(SurfaceMap, LongArmIsSpreadEvenly) {
  const TriangleMesh mesh = bent_arm();
  const DomainMesh drawn = spread_over_domain(mesh);
  EXPECT_LT(undersampled(mesh, drawn, 0.2), 0.01);
}

TEST(SurfaceMap, GivesBackPlacesOnTheSurface) {
  for (const TriangleMesh& mesh : {bent_arm(), torus_mesh(28, 11, 40, 16)}) {
    const DomainMesh drawn = spread_over_domain(mesh);
    DomainWalk walk(drawn);
    for (int t = 0; t < static_cast<int>(drawn.triangles.size()); t += 37) {
      const Eigen::Vector3d shares(0.2, 0.3, 0.5);
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (int c = 0; c < 3; ++c) p += shares[c] * drawn.corner(t, c, 0);
      const SurfacePlace found = walk.find(p);
      EXPECT_EQ(found.triangle, t);
      EXPECT_LT((found.shares - shares).norm(), 1e-9);  // rounding over the smallest triangles' areas, some 1e-6
    }
  }
}

TEST(SurfaceMap, RefusesWhatHasNoDomain) {
  TriangleMesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(spread_over_domain(open), InputError);
  TriangleMesh two = box_mesh({0, 0, 0}, {1, 1, 1});
  const TriangleMesh other = box_mesh({2, 2, 2}, {3, 3, 3});
  for (const Eigen::Vector3i& t : other.triangles) two.triangles.emplace_back(t.array() + 8);
  two.vertices_mm.insert(two.vertices_mm.end(), other.vertices_mm.begin(), other.vertices_mm.end());
  EXPECT_THROW(spread_over_domain(two), InputError);
}

#ifdef ISOSTACK_SHARED_DATA
TEST(SurfaceMap, RealMeshes) {
  for (const char* name : {"hand", "kitten"}) {
    const TriangleMesh mesh = obj_mesh(std::string(ISOSTACK_SHARED_DATA) + "/meshes/" + name + ".obj");
    if (mesh.triangles.empty()) GTEST_SKIP() << "the shared data are not here";
    const DomainMesh drawn = spread_over_domain(mesh);
    EXPECT_NEAR(covered_share(drawn), 1, 1e-9) << name;
    EXPECT_LT(undersampled(mesh, drawn, 0.2), 0.02) << name;  // a few tips get less than a fifth of their due
  }
}
#endif

}  // namespace
}  // namespace isostack

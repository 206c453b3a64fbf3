#include "recon/metrics/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/metrics/point_triangle.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using namespace testing_support;

TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfRadii) {
  const TriangleMesh inner = sphere_mesh({5, 6, 7}, 20, 120, 80), outer = sphere_mesh({5, 6, 7}, 23, 120, 80);
  const SurfaceDistance d = surface_distance(inner, outer, {.samples = 4000});
  const double sagitta = 0.04;  // 23 mm · (1 − cos 1.5°) twice: facets of 3° lie within the sphere
  EXPECT_NEAR(d.mean_mm, 3, sagitta);
  EXPECT_NEAR(d.percentile95_mm, 3, sagitta);
  EXPECT_NEAR(d.largest_mm, 3, sagitta);
}

TEST(SurfaceDistance, OfAShiftedSphereIsInClosedForm) {
  // Shifted by s, a point at angle t from the shift lies | |r e(t) - s| - r | = s |cos t| + O(s²) from the other
  // sphere: s/2 in the mean over the area, s at most.
  const double shift = 0.5;
  const SurfaceDistance d =
      surface_distance(sphere_mesh({0, 0, 0}, 20, 240, 160), sphere_mesh({shift, 0, 0}, 20, 240, 160));
  EXPECT_NEAR(d.mean_mm, shift / 2, 0.01);  // facets of 1.5°: 0.0035 mm; s²/r: 0.012; 25,000 samples: 0.001
  EXPECT_NEAR(d.percentile95_mm, 0.95 * shift, 0.015);  // |cos t| is uniform over the area
  EXPECT_NEAR(d.largest_mm, shift, 0.01);
}

TEST(SurfaceDistance, OfAMeshToItselfIsZero) {
  const TriangleMesh torus = torus_mesh(20, 6, 40, 30);
  EXPECT_LT(surface_distance(torus, torus, {.samples = 2000}).largest_mm, 1e-7);  // the root of the square's rounding
}

TEST(SurfaceDistance, SeesAPartOnlyOneOfThemHas) {
  const TriangleMesh big = box_mesh({0, 0, 0}, {10, 10, 10});
  TriangleMesh with_satellite = big;
  const TriangleMesh satellite = box_mesh({30, 4, 4}, {32, 6, 6});
  with_satellite.vertices_mm.insert(with_satellite.vertices_mm.end(), satellite.vertices_mm.begin(),
                                    satellite.vertices_mm.end());
  for (const Eigen::Vector3i& t : satellite.triangles) with_satellite.triangles.emplace_back((t.array() + 8).matrix());
  const SurfaceDistance there = surface_distance(big, with_satellite), back = surface_distance(with_satellite, big);
  EXPECT_NEAR(there.largest_mm, 22, 0.1);  // its far face; 25,000 samples leave 0.1 mm at most
  EXPECT_NEAR(back.largest_mm, 22, 0.1);
  // 24 of 624 mm² at 20 to 22 mm, one direction of two.
  EXPECT_NEAR(there.mean_mm, 24.0 / 624 * 21 / 2, 0.04);
  EXPECT_LT(there.percentile95_mm, 1e-6) << "less than 5 % of either surface";
}

TEST(SurfaceDistance, IsRepeatable) {
  const TriangleMesh a = sphere_mesh({0, 0, 0}, 10, 30, 20), b = box_mesh({-8, -8, -8}, {8, 8, 8});
  const SurfaceDistance one = surface_distance(a, b, {.samples = 500}), two = surface_distance(a, b, {.samples = 500});
  EXPECT_EQ(one.mean_mm, two.mean_mm);
  EXPECT_EQ(one.largest_mm, two.largest_mm);
  EXPECT_NE(one.mean_mm, surface_distance(a, b, {.samples = 500, .seed = 2}).mean_mm);
}

TEST(DistancesToMesh, OfABoxAreInClosedForm) {
  const auto distances = distances_to_mesh_mm({{5, 5, 12}, {5, 5, 9}, {13, 14, 5}, {11, 12, 12}, {10, 3, 3}},
                                              box_mesh({0, 0, 0}, {10, 10, 10}));
  const double expected[] = {2, 1, 5, 3, 0};  // unsigned; to faces, an edge and a corner
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(distances[i], expected[i], 1e-12) << i;
}

TEST(DistancesToMesh, EqualTheSmallestOverAllTriangles) {
  const TriangleMesh mesh = torus_mesh(20, 6, 25, 13);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-40, 40);
  std::vector<Eigen::Vector3d> points(200);
  for (Eigen::Vector3d& p : points) p = {uniform(random), uniform(random), uniform(random)};
  const auto distances = distances_to_mesh_mm(points, mesh);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const auto corner = [&](int c) { return mesh.vertices_mm[static_cast<std::size_t>(t[c])]; };
      const Triangle triangle = {corner(0), corner(1), corner(2)};
      nearest = std::min(nearest, (closest_point_on_triangle(triangle, points[i]) - points[i]).norm());
    }
    EXPECT_NEAR(distances[i], nearest, 1e-12);
  }
}

TEST(DistancesToMesh, OneTriangleIsAMesh) {
  const TriangleMesh mesh{
      .name = "t", .vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}, .normals = {}};
  EXPECT_NEAR(distances_to_mesh_mm({{0.2, 0.2, 3}}, mesh)[0], 3, 1e-12);
}

TEST(SampleSurface, IsUniformByAreaAndOnTheSurface) {
  const TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 2, 10});  // faces of 20, 10 and 2 mm², twice each
  const std::size_t count = 20'000;
  const auto samples = sample_surface(mesh, count, 3);
  ASSERT_EQ(samples.size(), count);
  std::size_t on_ends = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : samples) {
    on_ends += p.z() == 0 || p.z() == 10 ? 1 : 0;
    mean += p / static_cast<double>(count);
  }
  const double share = 4.0 / 64;
  EXPECT_NEAR(static_cast<double>(on_ends) / count, share, 4 * std::sqrt(share / count));  // four sigma
  EXPECT_NEAR(mean.z(), 5, 4 * 3.5 / std::sqrt(count));
  for (const double d : distances_to_mesh_mm(samples, mesh)) ASSERT_LT(d, 1e-7);
}

TEST(SurfaceDistance, RefusesAnEmptyMesh) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(surface_distance(box, {}), InputError);
  EXPECT_THROW(surface_distance({}, box), InputError);
  EXPECT_THROW(sample_surface({}, 10, 1), InputError);
  EXPECT_THROW(distances_to_mesh_mm({{0, 0, 0}}, {}), InputError);
}

}  // namespace
}  // namespace isostack

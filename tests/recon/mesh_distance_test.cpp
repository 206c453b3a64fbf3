#include "recon/distance/mesh_distance.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <limits>

#include "recon/distance/distance_surface.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/closest_point.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using namespace testing_support;
using Eigen::Vector3d;

/// Turned, anisotropic and sheared along k, round the world's origin: 25 mm in every direction.
Grid oblique_grid() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  Grid grid;
  grid.size = {52, 44, 34};
  grid.index_to_world.linear() << 1.0 * turn.col(0), 1.2 * turn.col(1), 1.5 * (turn.col(2) + 0.2 * turn.col(1));
  grid.index_to_world.translation() = -(grid.index_to_world.linear() * Vector3d(25.6, 21.3, 16.8));
  return grid;
}

struct Errors {
  double in_band_mm = 0, beyond_mm = 0, of_points_mm = 0;
};

/// Against a search through all triangles.
Errors errors_of(const MeshDistance& found, const TriangleMesh& mesh, double band_mm) {
  const ClosestPoint closest(mesh);
  const Grid& grid = found.distance_mm.grid;
  Errors errors;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vector3d point = grid.index_to_world * Vector3d(i, j, k);
        const double truth = (closest.on_mesh(point) - point).norm();
        const double error = std::abs(std::abs(static_cast<double>(found.distance_mm.at(i, j, k))) - truth);
        double& largest = truth <= band_mm ? errors.in_band_mm : errors.beyond_mm;
        largest = std::max(largest, error);
        const Vector3d& there = found.closest_points_mm[grid.offset(i, j, k)];
        errors.of_points_mm = std::max(errors.of_points_mm, std::abs((there - point).norm() - truth));
      }
  return errors;
}

TEST(MeshDistance, EqualsBruteForceOnBoxSphereAndTorus) {
  // The thin box has sharp edges and corners, the torus saddles, the sphere poles with many edges.
  for (const TriangleMesh& mesh :
       {box_mesh({-17, -12, -2}, {15, 13, 3}), sphere_mesh({0, 1, 2}, 18, 60, 30), torus_mesh(15, 5, 60, 24)}) {
    MeshDistanceOptions options;
    options.band_mm = 4;
    options.keep_closest = true;
    const MeshDistance found = mesh_distance(mesh, oblique_grid(), options);
    const Errors errors = errors_of(found, mesh, options.band_mm);
    EXPECT_LT(errors.in_band_mm, 1e-5) << mesh.name;  // floats of a few mm
    EXPECT_LT(errors.beyond_mm, 0.05) << mesh.name;   // carried triangles: a twentieth of a voxel
    EXPECT_LT(errors.of_points_mm, 0.05) << mesh.name;
    EXPECT_TRUE(found.remarks.empty());
  }
}

TEST(MeshDistance, IsPositiveExactlyInside) {
  const double ring = 15, tube = 5;
  const MeshDistance found = mesh_distance(torus_mesh(ring, tube, 120, 60), oblique_grid());
  const Grid& grid = found.distance_mm.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vector3d p = grid.index_to_world * Vector3d(i, j, k);
        const double truth = tube - std::hypot(std::hypot(p.x(), p.y()) - ring, p.z());
        if (std::abs(truth) <= 0.02) continue;  // the facets' depth
        ASSERT_EQ(found.distance_mm.at(i, j, k) > 0, truth > 0) << p.transpose();
      }
}

TEST(MeshDistance, BandHoldsWhatIsNearAndTheBandBeyond) {
  MeshDistanceOptions options;
  options.band_mm = 3;
  options.extent = DistanceExtent::band;
  options.keep_closest = true;
  const MeshDistance found = mesh_distance(box_mesh({-10, -10, -10}, {10, 10, 10}), oblique_grid(), options);
  const Grid& grid = found.distance_mm.grid;
  std::size_t near = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Vector3d q = (grid.index_to_world * Vector3d(i, j, k)).cwiseAbs() - Vector3d::Constant(10);
        const double inside = std::min(-q.maxCoeff(), 0.0) + std::max(-q.maxCoeff(), 0.0);
        const double truth = inside > 0 ? inside : -q.cwiseMax(0).norm();
        EXPECT_NEAR(found.distance_mm.at(i, j, k), std::clamp(truth, -3.0, 3.0), 1e-5);
        const MeshElement& element = found.closest_elements[grid.offset(i, j, k)];
        if (std::abs(std::abs(truth) - 3) > 0.01) {  // within the band, and only there, an element is known
          EXPECT_EQ(element.kind == MeshElement::Kind::none, std::abs(truth) > 3) << q.transpose();
        }
        if (q.minCoeff() > 0.01 && truth > -2.99) {
          EXPECT_EQ(element.kind, MeshElement::Kind::vertex);
          ++near;
        }
      }
  EXPECT_GT(near, 20u);  // some voxels are nearest to a corner
}

TEST(MeshDistance, DoesNotDependOnTheNumberOfThreads) {
  const TriangleMesh mesh = torus_mesh(15, 5, 60, 24);
  const MeshDistance many = mesh_distance(mesh, oblique_grid());
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(many.distance_mm.voxels, mesh_distance(mesh, oblique_grid()).distance_mm.voxels);
}

TEST(MeshDistance, OrientationDoesNotMatterAndIsRemarkedOn) {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 18, 60, 30);
  const MeshDistance right = mesh_distance(mesh, oblique_grid());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 7) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const MeshDistance mixed = mesh_distance(mesh, oblique_grid());
  const Grid& grid = right.distance_mm.grid;
  for (std::size_t v = 0; v < grid.voxel_count(); ++v)
    ASSERT_NEAR(mixed.distance_mm.voxels[v], right.distance_mm.voxels[v], 1e-5);  // rounding of other corners first
  ASSERT_EQ(mixed.remarks.size(), 1u);
  EXPECT_NE(mixed.remarks.front().find("disagree"), std::string::npos);
}

TEST(MeshDistance, SmallHolesAreClosedByWindingNumbers) {
  const double radius = 18;
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, radius, 60, 30);
  for (const std::size_t t : {900u, 901u, 1700u, 2500u})
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshDistance found = mesh_distance(mesh, oblique_grid());
  ASSERT_EQ(found.remarks.size(), 2u);
  EXPECT_NE(found.remarks.back().find("not closed"), std::string::npos);
  const Grid& grid = found.distance_mm.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const double r = (grid.index_to_world * Vector3d(i, j, k)).norm();
        if (std::abs(r - radius) <= 0.5) continue;  // about as deep as the patch over a hole of two triangles
        ASSERT_EQ(found.distance_mm.at(i, j, k) > 0, r < radius);
      }
}

TEST(MeshDistance, SurfaceOfTheVolumeIsTheMesh) {
  const TriangleMesh mesh = sphere_mesh({0, 1, 2}, 16, 80, 40);
  const TriangleMesh back = distance_surface(mesh_distance(mesh, oblique_grid()).distance_mm);
  const MeshMeasures measures = measure(back);
  EXPECT_TRUE(measures.watertight());
  EXPECT_EQ(measures.components, 1u);
  // Linear between voxels of up to 1.5 mm on a curvature of 1/16 mm: h²/(8·16) < 0.02 mm, three times at a diagonal.
  for (const double mm : distances_to_mesh_mm(back.vertices_mm, mesh)) ASSERT_LT(mm, 0.06);
  EXPECT_GT(measures.volume_mm3, 0);  // outward
}

TEST(MeshDistance, SaysWhatIsWrong) {
  EXPECT_THROW(mesh_distance({}, oblique_grid()), InputError);
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(mesh_distance(mesh, Grid()), GeometryError);
  mesh.vertices_mm[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mesh_distance(mesh, oblique_grid()), InputError);
  EXPECT_THROW(distance_surface(Volume<float>(oblique_grid(), 1.0f)), GeometryError);
}

}  // namespace
}  // namespace isostack

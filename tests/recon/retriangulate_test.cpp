#include "recon/surface/retriangulate.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <numbers>
#include <set>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/remesh.h"
#include "recon/surface/simplify.h"
#include "recon/surface/stack_caps.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::box_mesh;
using testing_support::field_of;
using testing_support::sphere_mesh;
using testing_support::sphere_mm;
using testing_support::torus_mesh;
using testing_support::torus_mm;

constexpr double pi = std::numbers::pi;

TriangleMesh extracted(const ScalarField& field, const std::vector<Eigen::Vector3d>& seeds, double half_size_mm,
                       double resolution_mm) {
  ExtractionOptions options;
  options.resolution_mm = resolution_mm;
  options.bounds =
      Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-half_size_mm), Eigen::Vector3d::Constant(half_size_mm));
  return extract_surface(field, seeds, options).mesh;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int offset = static_cast<int>(a.vertices_mm.size());
  a.vertices_mm.insert(a.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back(t.array() + offset);
  return a;
}

/// Closed, with the parts and handles it had, and turned outwards still.
void expect_same_topology(const TriangleMesh& before, const TriangleMesh& after) {
  const MeshMeasures was = measure(before), is = measure(after);
  EXPECT_EQ(is.components, was.components);
  EXPECT_EQ(is.genus, was.genus);
  EXPECT_EQ(is.boundary_edges, was.boundary_edges);
  EXPECT_EQ(is.non_manifold_edges + is.flipped_edges, 0u);
  EXPECT_GT(is.volume_mm3, 0);
}

TEST(Remesh, SphereGetsEvenTrianglesWithVerticesOnIt) {
  const ScalarField field = field_of([](const Eigen::Vector3d& p) { return sphere_mm(p, 20); });
  const TriangleMesh full = extracted(field, {{20, 0, 0}}, 30, 1);
  RetriangulationReport report;
  const TriangleMesh mesh = retriangulate(full, {.edge_length_mm = 2}, report, &field);
  expect_same_topology(full, mesh);
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    EXPECT_NEAR(mesh.vertices_mm[i].norm(), 20, 1e-4);  // root tolerance 1e-4 of segments of at most 1 mm
    EXPECT_GT(mesh.normals[i].dot(mesh.vertices_mm[i].normalized()), 0.999);
  }
  EXPECT_EQ(report.vertices_off_surface, 0u);
  // Equilateral triangles of edge 2 on 4π·400 mm² would be 2902; edges may be 4/5 to 4/3 of 2 mm.
  EXPECT_NEAR(static_cast<double>(report.triangles_after), 2902, 300);
  EXPECT_GT(report.quality.edge_percentile5_mm, 1.5);
  EXPECT_LT(report.quality.edge_percentile95_mm, 2.5);
  EXPECT_GT(report.quality.smallest_angle_deg, 25);
  EXPECT_GT(report.quality.mean_smallest_angle_deg, 50);
  EXPECT_LT(report.largest_distance_mm, 0.06);  // triangles of edge 8/3 mm lie at most a²/6r = 0.06 mm below
  const double volume = 4.0 / 3 * pi * 8000;
  EXPECT_NEAR(measure(mesh).volume_mm3, volume, 0.006 * volume);  // a²/8r of 2 mm edges, 0.025 mm on r/3
}

TEST(Remesh, TorusKeepsItsHandleFinerAndCoarserThanItWas) {
  const ScalarField field = field_of([](const Eigen::Vector3d& p) { return torus_mm(p, 20, 7); });
  const TriangleMesh full = extracted(field, {{27, 0, 0}}, 40, 1.3);
  for (const double edge_length_mm : {0.8, 3.0}) {
    RetriangulationReport report;
    const TriangleMesh mesh = retriangulate(full, {.edge_length_mm = edge_length_mm}, report, &field);
    expect_same_topology(full, mesh);
    EXPECT_NEAR(report.quality.median_edge_mm, edge_length_mm, 0.1 * edge_length_mm);
    EXPECT_GT(report.quality.smallest_angle_deg, 20);
    // Chords of length a lie a²/8r below the tube of radius r: its area and volume shrink by that, twice, of r.
    const double shrink = edge_length_mm * edge_length_mm / (4 * 49);
    EXPECT_NEAR(measure(mesh).area_mm2, 4 * pi * pi * 20 * 7, (0.001 + shrink) * 4 * pi * pi * 140);
    EXPECT_NEAR(measure(mesh).volume_mm3, 2 * pi * pi * 20 * 49, (0.001 + shrink) * 2 * pi * pi * 980);
    for (const Eigen::Vector3d& v : mesh.vertices_mm) EXPECT_NEAR(torus_mm(v, 20, 7), 0, 1e-3);
  }
}

TEST(Remesh, ThinSheetStaysTwoSided) {
  // A disc 1 mm thick under edges of 3 mm: the faces may not fall onto each other.
  const auto sheet = [](const Eigen::Vector3d& p) {
    const Eigen::Vector2d rim(std::max(0.0, p.head<2>().norm() - 15), p.z());
    return 0.5 - rim.norm();
  };
  const ScalarField field = field_of(sheet);
  const TriangleMesh full = extracted(field, {{0, 0, 0.5}}, 20, 0.5);
  RetriangulationReport report;
  const TriangleMesh mesh = retriangulate(full, {.edge_length_mm = 3}, report, &field);
  expect_same_topology(full, mesh);
  // Edges of 3 mm make a wedge of the rim, which is half a mm round; the faces are 1 mm apart and stay so.
  EXPECT_LT(report.largest_distance_mm, 1);
  const double volume = pi * 225 + pi * pi / 4 * 15;
  EXPECT_NEAR(measure(mesh).volume_mm3, volume, 2 * pi * 15 * 4 * 0.5 / 2);  // wedges as deep as the longest edges
  EXPECT_LT(mesh.triangles.size(), full.triangles.size() / 4);
}

TEST(Remesh, WithoutAFieldVerticesStayOnTheMeshAndABoxKeepsItsEdges) {
  const TriangleMesh box = box_mesh({-10, -6, -4}, {10, 6, 4});
  RetriangulationReport report;
  const TriangleMesh mesh = retriangulate(box, {.edge_length_mm = 1.5}, report);
  expect_same_topology(box, mesh);
  EXPECT_NEAR(measure(mesh).volume_mm3, 20 * 12 * 8, 1e-6 * 1920);  // creases and corners are where they were
  EXPECT_NEAR(measure(mesh).area_mm2, 2 * (240 + 160 + 96), 1e-6 * 992);
  EXPECT_NEAR(report.quality.median_edge_mm, 1.5, 0.2);
  EXPECT_LT(report.largest_distance_mm, 1e-9);
}

TEST(Remesh, BordersStayExactly) {
  const ScalarField field = field_of([](const Eigen::Vector3d& p) { return sphere_mm(p, 20); });
  const TriangleMesh open =
      clipped(extracted(field, {{20, 0, 0}}, 30, 1), {Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitZ(), 5.0)});
  const auto rim = [](const TriangleMesh& mesh) {
    std::set<std::array<double, 3>> points;
    for (const Eigen::Vector3d& v : mesh.vertices_mm)
      if (v.z() < -5 + 1e-9) points.insert({v.x(), v.y(), v.z()});
    return points;
  };
  RetriangulationReport report;
  for (const RetriangulationOptions& options :
       {RetriangulationOptions{.edge_length_mm = 1.5}, {.simplify_tolerance_mm = 0.1}, {.triangles = 500}}) {
    const TriangleMesh mesh = retriangulate(open, options, report, &field);
    expect_same_topology(open, mesh);
    EXPECT_EQ(rim(mesh), rim(open));
    EXPECT_LT(report.triangles_after, report.triangles_before);
  }
}

TEST(Remesh, ResultDoesNotDependOnThreads) {
  const TriangleMesh torus = torus_mesh(20, 7, 60, 30);
  const TriangleMesh first = remesh(torus, {.edge_length_mm = 2.5}).mesh;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const TriangleMesh second = remesh(torus, {.edge_length_mm = 2.5}).mesh;
  EXPECT_EQ(first.vertices_mm, second.vertices_mm);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(Remesh, TooManyTrianglesAreRefusedBeforeTheyAreMade) {
  EXPECT_THROW(remesh(sphere_mesh({0, 0, 0}, 100, 20, 10), {.edge_length_mm = 0.01}), GeometryError);
}

TEST(Simplify, SphereStaysWithinTheToleranceInFarFewerTriangles) {
  const TriangleMesh full = sphere_mesh({30, -10, 5}, 20, 90, 45);
  std::size_t fewer = full.triangles.size();
  for (const double tolerance_mm : {0.05, 0.2, 1.0}) {
    const TriangleMesh mesh = simplify(full, {.tolerance_mm = tolerance_mm});
    expect_same_topology(full, mesh);
    EXPECT_LE(surface_distance(full, mesh, {.samples = 100'000, .seed = 7}).largest_mm, tolerance_mm);
    // Triangles inscribed in a sphere lie e below it with edges of √(6re): the best there are number 4πr²/(√3/4·6re).
    const double inscribed = 4 * pi * 20 / (std::sqrt(3.0) / 4 * 6 * tolerance_mm);
    EXPECT_LT(static_cast<double>(mesh.triangles.size()), 2.5 * inscribed);
    EXPECT_LT(mesh.triangles.size(), fewer);
    fewer = mesh.triangles.size();
    const double volume = 4.0 / 3 * pi * 8000;
    EXPECT_NEAR(measure(mesh).volume_mm3, volume, 3 * tolerance_mm / 20 * volume);
  }
}

TEST(Simplify, TorusAndTwoPartsKeepTheirShapeDownToAFewTriangles) {
  const TriangleMesh full = joined(torus_mesh(20, 7, 80, 40), sphere_mesh({0, 0, 30}, 5, 40, 20));
  const TriangleMesh mesh = simplify(full, {.triangles = 300});
  expect_same_topology(full, mesh);
  EXPECT_LE(mesh.triangles.size(), 300u);
  EXPECT_GE(mesh.triangles.size(), 298u);  // a collapse takes two
  const double volume = 2 * pi * pi * 20 * 49 + 4.0 / 3 * pi * 125;
  EXPECT_NEAR(measure(mesh).volume_mm3, volume, 0.05 * volume);  // edges are as long as the tube's radius
  // Fewer than any torus and sphere can have: it stops before a part or the handle is lost.
  const TriangleMesh least = simplify(full, {.triangles = 4});
  expect_same_topology(full, least);
  EXPECT_LT(least.triangles.size(), 100u);
}

TEST(Simplify, FlatFacesNeedNoTriangles) {
  RetriangulationReport report;
  const TriangleMesh fine = retriangulate(box_mesh({-10, -6, -4}, {10, 6, 4}), {.edge_length_mm = 1}, report);
  const TriangleMesh mesh = simplify(fine, {.tolerance_mm = 0.001});
  expect_same_topology(fine, mesh);
  EXPECT_LT(mesh.triangles.size(), 100u);  // twelve at best
  EXPECT_NEAR(measure(mesh).volume_mm3, 1920, 0.001 * measure(fine).area_mm2);
}

TEST(Simplify, ThinSheetsDoNotComeThroughEachOther) {
  // Two parallel faces 0.2 mm apart and a tolerance of 0.15 mm: each may move, the sheet stays closed and thick.
  const TriangleMesh sheet = [] {
    RetriangulationReport report;
    return retriangulate(box_mesh({-10, -10, -0.1}, {10, 10, 0.1}), {.edge_length_mm = 1}, report);
  }();
  const TriangleMesh mesh = simplify(sheet, {.tolerance_mm = 0.15});
  expect_same_topology(sheet, mesh);
  EXPECT_LE(largest_distance_mm(sheet, mesh), 0.15);
  EXPECT_NEAR(measure(mesh).volume_mm3, 400 * 0.2, 0.2 * 400 * 0.2);
}

TEST(Retriangulate, AMeshThatIsNotManifoldIsRefused) {
  TriangleMesh fan;
  fan.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  fan.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_THROW(simplify(fan, {.triangles = 4}), GeometryError);
  TriangleMesh turned = box_mesh({0, 0, 0}, {1, 1, 1});
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_THROW(remesh(turned, {.edge_length_mm = 0.3}), GeometryError);
}

TEST(Retriangulate, SheetsThatTouchInAPointStayTouching) {
  // Two boxes with one corner in common: a closed surface whose vertex has two fans.
  TriangleMesh boxes = joined(box_mesh({0, 0, 0}, {4, 4, 4}), box_mesh({4, 4, 4}, {8, 8, 8}));
  for (Eigen::Vector3i& t : boxes.triangles)
    for (int& v : t)
      if (v == 8) v = 7;
  RetriangulationReport report;
  const TriangleMesh fine = retriangulate(boxes, {.edge_length_mm = 1}, report);
  expect_same_topology(boxes, fine);
  const TriangleMesh coarse = retriangulate(fine, {.simplify_tolerance_mm = 0.01}, report);
  expect_same_topology(boxes, coarse);
  EXPECT_NEAR(measure(coarse).volume_mm3, 128, 0.5);
}

}  // namespace
}  // namespace isostack

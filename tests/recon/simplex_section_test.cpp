#include "recon/subdivision/simplex_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "recon/metrics/mesh_measures.h"
#include "recon/subdivision/subdivision_levels.h"

namespace isostack {
namespace {

/// Regular polygons of the radii below at t = 0 and above at t = 10, joined by triangles.
SimplicialMesh cone(int corners, double below_mm, double above_mm) {
  SimplicialMesh mesh;
  mesh.vertices.resize(3, 2 * corners);
  mesh.simplices.resize(3, 2 * corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const int next = (i + 1) % corners;
    mesh.vertices.col(i) << below_mm * std::cos(angle), below_mm * std::sin(angle), 0;
    mesh.vertices.col(corners + i) << above_mm * std::cos(angle), above_mm * std::sin(angle), 10;
    mesh.simplices.col(2 * i) << i, next, corners + i;
    mesh.simplices.col(2 * i + 1) << next, corners + next, corners + i;
  }
  return mesh;
}

double polygon_area(int corners, double radius_mm) {
  return corners * radius_mm * radius_mm * std::sin(2 * std::numbers::pi / corners) / 2;
}

/// An octahedron of radius r that keeps its shape from t = 0 to 10, as three tetrahedra per face, then halved.
SimplicialMesh octahedron_through_time(double r, int levels) {
  SimplicialMesh mesh;
  mesh.vertices.resize(4, 12);
  for (int v = 0; v < 6; ++v) {
    mesh.vertices.col(v).setZero();
    mesh.vertices(v / 2, v) = v % 2 == 0 ? r : -r;
    mesh.vertices.col(v + 6) = mesh.vertices.col(v);
    mesh.vertices(3, v + 6) = 10;
  }
  std::vector<Eigen::Vector4i> tetrahedra;
  for (int face = 0; face < 8; ++face) {
    const int x = face & 1, y = 2 + ((face >> 1) & 1), z = 4 + ((face >> 2) & 1);
    const bool turned = ((x + y + z) & 1) != 0;
    // In the order of their numbers the corners a < b < c give three tetrahedra that neighbours agree on.
    const auto add = [&](Eigen::Vector4i t) {
      if (turned) std::swap(t[2], t[3]);
      tetrahedra.push_back(t);
    };
    add({x, x + 6, y + 6, z + 6});
    add({x, y + 6, y, z + 6});
    add({x, y, z, z + 6});
  }
  mesh.simplices.resize(4, static_cast<Eigen::Index>(tetrahedra.size()));
  for (std::size_t s = 0; s < tetrahedra.size(); ++s) mesh.simplices.col(static_cast<Eigen::Index>(s)) = tetrahedra[s];
  for (const SimplexSubdivision& step : subdivision_levels(mesh.simplices, 12, levels).steps)
    mesh = {.vertices = midpoint_refined(mesh.vertices, step), .simplices = step.simplices};
  return mesh;
}

TEST(SectionContours, AreThePolygonInBetweenWithTheInsideToTheLeft) {
  const SimplicialMesh mesh = cone(12, 5, 9);
  const std::vector<Contour> contours = section_contours(mesh, values_at_time(mesh, 2.5));
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_NEAR(signed_area_mm2(contours[0]), polygon_area(12, 6), 1e-9);  // sides are flat: rounding
  EXPECT_EQ(contours[0].depth, 0);
}

TEST(SectionContours, AtTheEndsAreTheSourcesPointForPoint) {
  const SimplicialMesh mesh = cone(12, 5, 9);
  for (const bool at_end : {false, true}) {
    const std::vector<Contour> contours =
        section_contours(mesh, values_at_time(mesh, at_end ? 10 : 0), at_end ? OnSection::beyond : OnSection::before);
    ASSERT_EQ(contours.size(), 1U);
    ASSERT_EQ(contours[0].points_mm.size(), 12U);
    for (const Eigen::Vector2d& point : contours[0].points_mm)
      EXPECT_TRUE((mesh.vertices.topRows<2>().colwise() - point).colwise().norm().minCoeff() == 0);
    EXPECT_NEAR(signed_area_mm2(contours[0]), polygon_area(12, at_end ? 9 : 5), 1e-9);  // rounding
  }
}

TEST(SectionContours, FollowACurvedTime) {
  const SimplicialMesh mesh = cone(400, 5, 5);
  // On t = 5 + x / 2 the contour is the circle again; its places have the t that the surface asks for.
  const Eigen::VectorXd values = mesh.vertices.row(2) - (5 + mesh.vertices.row(0).array() / 2).matrix();
  const std::vector<Contour> contours = section_contours(mesh, values);
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_NEAR(signed_area_mm2(contours[0]), polygon_area(400, 5), 0.01);  // of 78.5; chords between 400 corners
}

TEST(SectionMesh, OfAnUnchangingBodyIsThatBodyClosedAndOutsideOut) {
  const SimplicialMesh mesh = octahedron_through_time(6, 2);
  for (const double t : {0.0, 1.7, 5.0, 8.1, 10.0}) {
    const TriangleMesh body =
        section_mesh(mesh, values_at_time(mesh, t), t > 0 ? OnSection::beyond : OnSection::before);
    const MeshMeasures measures = measure(body);
    EXPECT_NEAR(measures.volume_mm3, 4.0 / 3 * 216, 1e-9) << t;  // flat faces: rounding
    EXPECT_TRUE(measures.watertight()) << t;
    EXPECT_EQ(measures.genus, 0) << t;
  }
}

}  // namespace
}  // namespace isostack

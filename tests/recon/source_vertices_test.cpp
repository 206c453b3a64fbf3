#include "recon/subdivision/source_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/subdivision/face_triangulation.h"
#include "recon/subdivision/simplex_section.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/tetrahedra.h"

namespace isostack {
namespace {

using testing_support::box_mesh;
using testing_support::sphere_mesh;
using testing_support::torus_mesh;

double area(const std::array<Eigen::Vector2d, 3>& p) {
  return ((p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y())) / 2;
}

TEST(FaceTriangulation, FillsTheTriangleAndHasTheEdges) {
  std::vector<Eigen::Vector2d> points{{0, 0}, {4, 0}, {0, 3}};
  FaceTriangulation face({points[0], points[1], points[2]});
  const auto inside = [&](double x, double y) {
    points.emplace_back(x, y);
    return face.add_inside(points.back());
  };
  const auto on_side = [&](int side, double x, double y) {
    points.emplace_back(x, y);
    return face.add_on_side(side, points.back());
  };
  const int right = on_side(0, 3, 0), left = on_side(0, 1, 0), slope = on_side(1, 2, 1.5);
  const int a = inside(0.5, 0.5), b = inside(2.5, 0.4), c = inside(1, 1), d = inside(1.2, 0.2);
  face.make_delaunay();
  face.join(slope, d);
  face.join(a, b);  // crosses it: is left out
  face.join(left, c);
  face.make_delaunay();
  double sum = 0;
  std::set<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& t : face.triangles()) {
    const auto p = [&](int i) { return points[static_cast<std::size_t>(t[i])]; };
    EXPECT_GT(area({p(0), p(1), p(2)}), 0);
    sum += area({p(0), p(1), p(2)});
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax({t[i], t[(i + 1) % 3]}));
  }
  EXPECT_NEAR(sum, 6, 1e-12);
  EXPECT_EQ(face.triangles().size(), 2 * 4 + 3 + 1u);  // Euler: four points inside, three on the sides
  EXPECT_TRUE(edges.count(std::minmax({slope, d})));
  EXPECT_TRUE(edges.count(std::minmax({left, c})));
  EXPECT_FALSE(edges.count(std::minmax({a, b})));
  EXPECT_TRUE(edges.count({1, right}));
}

struct Case {
  std::vector<BodyLayer> layers;
  int levels;
  long euler;
};

/// An interpolator that is not optimised: details linger.
SimplicialMesh unsmoothed(const BodyInterpolator& bodies, const FitProblem& problem) {
  SimplicialMesh mesh{.vertices = problem.base, .simplices = problem.levels.simplices(problem.levels.finest())};
  for (const SimplexSubdivision& step : problem.levels.steps) mesh.vertices = midpoint_refined(mesh.vertices, step);
  mesh.vertices.topRows(3) = problem.reference.back();
  EXPECT_EQ(bodies.base.simplices.rows(), 4);
  return mesh;
}

class SourceVertices : public ::testing::TestWithParam<int> {
 protected:
  static Case made() {
    switch (GetParam()) {
      case 0:
        return {{{0, sphere_mesh({0, 0, 0}, 20, 24, 18)}, {30, box_mesh({-20, -18, -16}, {20, 18, 16})}}, 2, 2};
      case 1:
        return {{{0, torus_mesh(28, 11, 30, 14)}, {30, torus_mesh(20, 9, 24, 12)}}, 2, 0};
      default:
        return {{{0, sphere_mesh({0, 0, 0}, 20, 24, 18)},
                 {10, box_mesh({-20, -18, -16}, {20, 18, 16})},
                 {30, sphere_mesh({3, 0, 0}, 15, 12, 9)}},
                1,
                2};
    }
  }
};

TEST_P(SourceVertices, EndsAreTheSurfacesThemselves) {
  const Case given = made();
  const BodyInterpolator bodies = body_interpolator(given.layers, {.levels = given.levels});
  const FitProblem problem = fit_problem(bodies, true);
  const SimplicialMesh mesh = with_source_vertices(unsmoothed(bodies, problem), bodies, problem.levels);
  const testing_support::TetrahedraCount counted = testing_support::count(mesh.simplices);
  EXPECT_EQ(counted.crowded_triangles, 0u);
  EXPECT_EQ(counted.bad_links, 0u);
  EXPECT_EQ(counted.euler_characteristic, given.euler);
  for (std::size_t i = 0; i < given.layers.size(); ++i) {
    const TriangleMesh& body = given.layers[i].body;
    const TriangleMesh frame =
        section_mesh(mesh, values_at_time(mesh, given.layers[i].t_mm), i == 0 ? OnSection::before : OnSection::beyond);
    std::set<std::array<double, 3>> places;
    for (const Eigen::Vector3d& p : frame.vertices_mm) places.insert({p.x(), p.y(), p.z()});
    for (const Eigen::Vector3d& p : body.vertices_mm) EXPECT_TRUE(places.count({p.x(), p.y(), p.z()}));
    const MeshMeasures is = measure(frame), expected = measure(body);
    EXPECT_TRUE(is.watertight());
    EXPECT_EQ(is.euler_characteristic, expected.euler_characteristic);
    // The same polyhedron, cut up along the finest level's edges: rounding alone.
    EXPECT_NEAR(is.volume_mm3, expected.volume_mm3, 1e-6 * expected.volume_mm3);
    EXPECT_NEAR(is.area_mm2, expected.area_mm2, 1e-6 * expected.area_mm2);
  }
}

TEST_P(SourceVertices, EverySectionIsAClosedManifoldOfTheGenus) {
  const Case given = made();
  const BodyInterpolator bodies = body_interpolator(given.layers, {.levels = given.levels});
  const FitProblem problem = fit_problem(bodies, true);
  const SimplicialMesh mesh = with_source_vertices(unsmoothed(bodies, problem), bodies, problem.levels);
  for (const double t : {0.001, 1.0, 5.0, 7.5, 10.0, 11.0, 15.0, 22.5, 29.99}) {  // quarters of 30: at vertices
    const MeshMeasures measures = measure(section_mesh(mesh, values_at_time(mesh, t)));
    EXPECT_TRUE(measures.watertight()) << t;
    EXPECT_EQ(measures.components, 1u) << t;
    EXPECT_EQ(measures.euler_characteristic, given.euler) << t;
    EXPECT_GT(measures.volume_mm3, 0) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, SourceVertices, ::testing::Values(0, 1, 2));

TEST(BodyInterpolator, NamesBothGenera) {
  TriangleMesh ball = sphere_mesh({0, 0, 0}, 20, 12, 9), ring = torus_mesh(20, 9, 24, 12);
  ball.name = "ball";
  ring.name = "ring";
  try {
    body_interpolator({{0, ball}, {1, ring}}, {});
    FAIL() << "bodies of different genus";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const char* part : {"ball", "ring", "genus 0", "genus 1", "variational", "level-set", "blend"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace isostack

// Morphs between bodies: one function in four dimensions and more, whose sections are the frames.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/morph_meshes.h"

namespace isostack {
namespace {

using testing_support::knot_mesh;
using testing_support::moved;
using testing_support::sphere_mesh;
using testing_support::star_mesh;
using testing_support::together;
using testing_support::torus_mesh;

const Eigen::Vector3d origin = Eigen::Vector3d::Zero();

TriangleMesh sphere() { return sphere_mesh(origin, 20, 64, 32); }
TriangleMesh torus() { return torus_mesh(20, 8, 96, 40); }

std::vector<KeyShape> keys(const std::vector<TriangleMesh>& meshes) {
  std::vector<KeyShape> shapes;
  for (const TriangleMesh& mesh : meshes) shapes.push_back({.name = mesh.name, .shape = mesh});
  return shapes;
}

VariationalMorphOptions options(std::size_t constraints) {
  VariationalMorphOptions result;
  result.max_constraints = constraints;
  result.resolution_mm = 1.2;
  return result;
}

TriangleMesh body(const Shape& shape) { return std::get<TriangleMesh>(shape); }

void expect_closed(const TriangleMesh& mesh) {
  const MeshMeasures measures = measure(mesh);
  EXPECT_TRUE(measures.watertight());
  EXPECT_GT(measures.volume_mm3, 0);
}

/// Mean distance within `percent` of the diagonal (the issue asks 0.5).
void expect_near(const TriangleMesh& frame, const TriangleMesh& given, double percent) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : given.vertices_mm) box.extend(v);
  EXPECT_LT(surface_distance(frame, given).mean_mm, percent / 100 * box.diagonal().norm());
  EXPECT_EQ(measure(frame).components, measure(given).components);
  EXPECT_EQ(measure(frame).genus, measure(given).genus);
}

class BodyRecipes : public testing::TestWithParam<MorphRecipe> {};

TEST_P(BodyRecipes, ASphereBecomesATorus) {
  VariationalMorphOptions given = options(3000);
  given.recipe = GetParam();
  const Morph morph = variational_morph(keys({sphere(), torus()}), given);
  const std::vector<Shape> frames = morph.frames(9);
  ASSERT_EQ(frames.size(), 9U);
  for (const Shape& frame : frames) expect_closed(body(frame));
  expect_near(body(frames.front()), sphere(), 0.1);
  expect_near(body(frames.back()), torus(), 0.1);
  // The hole opens once and stays.
  double genus = 0;
  for (const Shape& frame : frames) {
    EXPECT_EQ(measure(body(frame)).components, 1U);
    EXPECT_GE(measure(body(frame)).genus, genus);
    genus = measure(body(frame)).genus;
  }
}

INSTANTIATE_TEST_SUITE_P(All, BodyRecipes, testing::Values(MorphRecipe::signed_distance, MorphRecipe::turk_obrien));

TEST(VariationalBodies, SequencesAndSingleFramesAreTheSame) {
  const Morph morph = variational_morph(keys({sphere(), torus()}), options(1500));
  const std::vector<Shape> frames = morph.frames(3);
  EXPECT_EQ(body(frames[1]).vertices_mm, body(morph.shape_at(0.5)).vertices_mm);
}

TEST(VariationalBodies, TurnedRoundInTimeTheMorphIsTheSame) {
  const Morph forth = variational_morph(keys({sphere(), torus()}), options(1500));
  const Morph back = variational_morph(keys({torus(), sphere()}), options(1500));
  for (const double t : {0.3, 0.5}) {
    const TriangleMesh a = body(forth.shape_at(t)), b = body(back.shape_at(1 - t));
    // Solved to 1e-5 of the box: vertices on the same cell edges, at f = 0 to 1e-4 of a cell.
    ASSERT_EQ(a.vertices_mm.size(), b.vertices_mm.size());
    for (std::size_t i = 0; i < a.vertices_mm.size(); ++i)
      EXPECT_LT((a.vertices_mm[i] - b.vertices_mm[i]).norm(), 0.01);
  }
}

TEST(VariationalBodies, ARigidMotionOfAllShapesMovesEveryFrame) {
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(300, -200, 90) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const Morph there = variational_morph(keys({moved(sphere(), motion), moved(torus(), motion)}), options(3000));
  const Morph here = variational_morph(keys({sphere(), torus()}), options(3000));
  const TriangleMesh frame = body(there.shape_at(0.4)), expected = moved(body(here.shape_at(0.4)), motion);
  // Cells lie otherwise in the body: the frames' chords differ, 1.2 mm cells on a radius of 8 mm by 0.02 mm.
  EXPECT_LT(surface_distance(frame, expected).mean_mm, 0.03);
  EXPECT_NEAR(measure(frame).volume_mm3, measure(expected).volume_mm3, 2e-3 * measure(expected).volume_mm3);
}

// At the ends there is one ball; the second one, between them, no key shape's frame before or after knows.
TEST(VariationalBodies, ABodyAppearsAndVanishes) {
  const TriangleMesh ball = sphere_mesh(Eigen::Vector3d(-20, 0, 0), 15, 48, 24);
  const TriangleMesh both = together(ball, sphere_mesh(Eigen::Vector3d(25, 0, 0), 5, 32, 16));
  const Morph morph = variational_morph(keys({ball, both, ball}), options(3000));
  for (const double t : {0.0, 0.25, 0.75, 1.0}) {
    expect_closed(body(morph.shape_at(t)));
    EXPECT_EQ(measure(body(morph.shape_at(t))).components, 1U);
  }
  expect_near(body(morph.shape_at(0)), ball, 0.2);
  expect_near(body(morph.shape_at(0.5)), both, 0.2);
  for (const double t : {0.45, 0.55}) {
    expect_closed(body(morph.shape_at(t)));
    EXPECT_EQ(measure(body(morph.shape_at(t))).components, 2U);
  }
}

TEST(VariationalBodies, AFrameMayBeEmpty) {
  const TriangleMesh here = sphere_mesh(Eigen::Vector3d(-40, 0, 0), 4, 32, 16);
  const TriangleMesh there = sphere_mesh(Eigen::Vector3d(40, 0, 0), 4, 32, 16);
  const Morph morph = variational_morph(keys({here, there}), options(1000));
  expect_near(body(morph.shape_at(0)), here, 0.5);
  EXPECT_TRUE(body(morph.shape_at(0.5)).triangles.empty());  // small, far apart, and nothing between them
  EXPECT_TRUE(body(morph.shape_at(0.5)).vertices_mm.empty());
}

TEST(VariationalBodies, ThreeShapesAtTheCornersOfATriangleAreReproduced) {
  const std::vector<TriangleMesh> given = {star_mesh(30, 96, 48), knot_mesh(30, 4, 200, 20), torus()};
  VariationalMorphOptions at_corners = options(6000);
  at_corners.layout = KeyLayout::simplex;
  const Morph morph = variational_morph(keys(given), at_corners);
  EXPECT_EQ(morph.places().coordinates.rows(), 2);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const TriangleMesh frame = body(morph.at(Eigen::VectorXd::Unit(3, i)));
    expect_closed(frame);
    expect_near(frame, given[static_cast<std::size_t>(i)], 0.3);
  }
  // Half-way between star and knot is another body when a third of the way leads by the torus.
  const TriangleMesh straight = body(morph.at(Eigen::Vector3d(0.5, 0.5, 0)));
  const TriangleMesh by_torus = body(morph.at(Eigen::Vector3d(0.25, 0.25, 0.5)));
  expect_closed(straight);
  expect_closed(by_torus);
  EXPECT_GT(surface_distance(straight, by_torus).mean_mm, 1);
}

TEST(VariationalBodies, AnOpenMeshIsRefusedByName) {
  std::vector<KeyShape> shapes = keys({sphere(), torus()});
  shapes[1].name = "open torus";
  std::get<TriangleMesh>(shapes[1].shape).triangles.pop_back();
  try {
    variational_morph(shapes, options(600));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("open torus"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace isostack

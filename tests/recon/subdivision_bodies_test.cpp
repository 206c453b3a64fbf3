#include "recon/morphing/subdivision_bodies.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "recon/geometry/errors.h"
#include "recon/metrics/closest_point.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/body_features.h"
#include "recon/morphing/subdivision_morph.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using testing_support::box_mesh;
using testing_support::sphere_mesh;
using testing_support::torus_mesh;

TriangleMesh octahedron(double radius_mm) {
  TriangleMesh mesh{.name = "octahedron", .vertices_mm = {}, .triangles = {}, .normals = {}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) mesh.vertices_mm.push_back(sign * radius_mm * Eigen::Vector3d::Unit(axis));
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// A smooth head with a nose at −y.
TriangleMesh head() {
  TriangleMesh mesh = sphere_mesh({0, 0, 0}, 1, 32, 24);
  for (Eigen::Vector3d& p : mesh.vertices_mm)
    p = Eigen::Vector3d(24 * p.x(), 30 * p.y(), 34 * p.z()) *
        (1 + 0.3 * std::exp(-20 * (p - Eigen::Vector3d(0, -1, 0)).squaredNorm()));
  return mesh;
}

int farthest(const TriangleMesh& mesh, const Eigen::Vector3d& direction) {
  const auto along = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.dot(direction) < b.dot(direction);
  };
  return static_cast<int>(std::max_element(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), along) -
                          mesh.vertices_mm.begin());
}

KeyShape key(const std::string& name, TriangleMesh mesh) { return {.name = name, .shape = std::move(mesh)}; }

const TriangleMesh& mesh_of(const Shape& shape) { return std::get<TriangleMesh>(shape); }

void expect_frames(const Morph& morph, const std::vector<TriangleMesh>& ends, std::size_t count, long euler) {
  const std::vector<Shape> frames = morph.frames(count);
  for (const Shape& frame : frames) {
    const MeshMeasures measures = measure(mesh_of(frame));
    EXPECT_TRUE(measures.watertight());
    EXPECT_EQ(measures.components, 1u);
    EXPECT_EQ(measures.euler_characteristic, euler);
    EXPECT_GT(measures.volume_mm3, 0);
  }
  for (const auto& [frame, end] :
       {std::pair(&frames.front(), &ends.front()), std::pair(&frames.back(), &ends.back())}) {
    EXPECT_NEAR(measure(mesh_of(*frame)).volume_mm3, measure(*end).volume_mm3, 1e-6 * measure(*end).volume_mm3);
    std::set<std::array<double, 3>> places;
    for (const Eigen::Vector3d& p : mesh_of(*frame).vertices_mm) places.insert({p.x(), p.y(), p.z()});
    for (const Eigen::Vector3d& p : end->vertices_mm) EXPECT_TRUE(places.count({p.x(), p.y(), p.z()}));
  }
}

TEST(SubdivisionBodies, OctahedronToHeadKeepsItsEdges) {
  const TriangleMesh first = octahedron(40), second = head();
  SubdivisionMorphOptions options;
  options.levels = 2;
  options.sharp_angle_rad = 0.5;
  const Morph morph = subdivision_morph({key("octahedron", first), key("head", second)}, options);
  expect_frames(morph, {first, second}, 5, 2);
  for (const FitLevelReport& level : morph.report().levels) {
    EXPECT_LE(level.energy, level.first_energy);
    EXPECT_LE(level.residual_mm, level.first_residual_mm);
  }
}

/// The nose's tip comes from the octahedron's left corner: every frame passes within 1 % of the straight line.
TEST(SubdivisionBodies, FeaturesStayOnTheirLine) {
  const TriangleMesh first = octahedron(40), second = head();
  const Eigen::Vector3d from = first.vertices_mm[1];
  const int tip = farthest(second, {0, -1, 0});
  const Eigen::Vector3d to = second.vertices_mm[static_cast<std::size_t>(tip)];
  SubdivisionMorphOptions options;
  options.levels = 3;
  CorrespondingPoints pair;
  pair.from = {.shape = 0, .vertex = 1, .place_mm = {}};
  pair.to = {.shape = 1, .vertex = {}, .place_mm = to};
  options.features = {pair};
  const Morph morph = subdivision_morph({key("octahedron", first), key("head", second)}, options);
  const std::size_t count = 9;
  const std::vector<Shape> frames = morph.frames(count);
  const double diagonal = 80 * std::sqrt(3.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    const Eigen::Vector3d on_line = (1 - t) * from + t * to;
    EXPECT_LT((ClosestPoint(mesh_of(frames[i])).on_mesh(on_line) - on_line).norm(), 0.01 * diagonal) << t;
  }
}

TEST(SubdivisionBodies, RingsStayRings) {
  const TriangleMesh first = torus_mesh(28, 11, 36, 18), second = torus_mesh(22, 6, 30, 12);
  SubdivisionMorphOptions options;
  options.levels = 2;
  expect_frames(subdivision_morph({key("thick", first), key("thin", second)}, options), {first, second}, 5, 0);
}

TEST(SubdivisionBodies, GoesThroughAllKeyShapes) {
  const TriangleMesh box = box_mesh({-20, -18, -16}, {20, 18, 16});
  const std::vector<KeyShape> shapes{key("ball", sphere_mesh({0, 0, 0}, 20, 16, 12)), key("box", box),
                                     key("egg", head())};
  SubdivisionMorphOptions options;
  options.levels = 2;
  const Morph morph = subdivision_morph(shapes, options);
  EXPECT_NEAR(measure(mesh_of(morph.shape_at(0.5))).volume_mm3, 40.0 * 36 * 32, 1e-6 * 40 * 36 * 32);
}

/// What fades with the paper's method lingers on request: half-way between two equal shapes is that shape.
TEST(SubdivisionBodies, LingeringDetailsKeepAShapeItself) {
  const TriangleMesh ball = sphere_mesh({0, 0, 0}, 20, 24, 18);
  SubdivisionMorphOptions options;
  options.levels = 3;
  options.smoothing_passes = 0;
  options.details = DetailsBetween::linger;
  const Morph morph = subdivision_morph({key("a", ball), key("b", ball)}, options);
  // The finest level's facets, 1.6 mm long on a radius of 20 mm, take 0.5 %, and their sections as much again.
  EXPECT_NEAR(measure(mesh_of(morph.shape_at(0.5))).volume_mm3, measure(ball).volume_mm3,
              0.03 * measure(ball).volume_mm3);
}

/// Half-way the side is pulled out, and only there.
TEST(SubdivisionBodies, TransitionsPullTheSequence) {
  const TriangleMesh ball = sphere_mesh({0, 0, 0}, 20, 24, 18);
  SubdivisionMorphOptions options;
  options.levels = 3;
  options.details = DetailsBetween::linger;
  EnhancedTransition pull;
  pull.level = 2;
  pull.at = {.t = 0.5, .place_mm = Eigen::Vector3d(20, 0, 0)};
  pull.to_mm = Eigen::Vector3d(40, 0, 0);
  const std::vector<KeyShape> shapes{key("a", ball), key("b", ball)};
  const Morph alone = subdivision_morph(shapes, options);
  options.transitions = {pull};
  const Morph pulled = subdivision_morph(shapes, options);
  const auto reach = [&](const Morph& morph, double t, const Eigen::Vector3d& direction) {
    const TriangleMesh frame = mesh_of(morph.shape_at(t));
    return frame.vertices_mm[static_cast<std::size_t>(farthest(frame, direction))].dot(direction);
  };
  EXPECT_NEAR(reach(pulled, 0.5, {1, 0, 0}), 40, 0.5);  // the pulled vertex itself, but for the tip beside it
  EXPECT_NEAR(reach(pulled, 0.5, {-1, 0, 0}), reach(alone, 0.5, {-1, 0, 0}), 0.2);  // it does not reach so far
  EXPECT_NEAR(reach(pulled, 1, {1, 0, 0}), reach(alone, 1, {1, 0, 0}), 1e-9);       // the shape itself
}

TEST(BodyFeatures, FindsCornersAndRefusesWhatIsNotThere) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(sharp_corners(box, 0.5, 24).size(), 8u);
  EXPECT_EQ(sharp_corners(box, 0.5, 5).size(), 5u);
  EXPECT_TRUE(sharp_corners(box, 1.6, 24).empty());  // edges of a box turn by 90°, 1.57
  CorrespondingPoints pair;
  pair.from = {.shape = 0, .vertex = 3, .place_mm = {}};
  pair.to = {.shape = 1, .vertex = {}, .place_mm = Eigen::Vector3d(0, 2, 0.1)};
  EXPECT_EQ(features_in({box, box}, {pair}).pairs[0][0].to, 2);
  pair.to.place_mm = Eigen::Vector3d(0.5, 1, 1.5);
  EXPECT_THROW(features_in({box, box}, {pair}), InputError);
  pair.to.vertex = 8;
  EXPECT_THROW(features_in({box, box}, {pair}), InputError);
  pair.to = {.shape = 2, .vertex = 0, .place_mm = {}};
  EXPECT_THROW(features_in({box, box, box}, {pair}), InputError);
}

}  // namespace
}  // namespace isostack

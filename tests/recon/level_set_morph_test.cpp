#include "recon/morphing/level_set_morph.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/frame_quality.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::figure;
using testing_support::largest_distance;
using testing_support::moved;
using testing_support::o_figure;
using testing_support::sphere_mesh;
using testing_support::torus_mesh;
using testing_support::x_figure;

/// How far a frame is from the circle about (50, 50) with this radius.
double off_circle(const Shape& frame, double radius_mm) {
  return largest_distance(contours_of(frame), contours_of(disc("", {50, 50}, radius_mm).shape));
}

std::vector<KeyShape> discs(const std::vector<double>& radii_mm) {
  std::vector<KeyShape> shapes;
  for (const double radius : radii_mm) shapes.push_back(disc("disc", {50, 50}, radius));
  return shapes;
}

void expect_monotone(const LevelSetCourse& course) {
  for (std::size_t i = 1; i < course.steps.size(); ++i) {
    EXPECT_GE(course.steps[i].shared_fraction, course.steps[i - 1].shared_fraction);
    EXPECT_GE(course.steps[i].matched_fraction, course.steps[i - 1].matched_fraction);
  }
}

TEST(LevelSetMorph, DistancesOfDiscsDecayExponentially) {
  // R' = d_B = 30 - R: the gap shrinks by e per unit of time, whose end is where the evolution stops.
  const LevelSetMorph result =
      run_level_set_morph(plan_level_set_morph(discs({10, 30}), {.pacing = FramePacing::time}));
  const double end = result.courses[0].steps.back().time;
  for (const double t : {0.0, 0.1, 0.25, 0.5, 1.0})
    EXPECT_LT(off_circle(result.morph.shape_at(t), 30 - 20 * std::exp(-t * end)), 0.3) << t;  // first-order in time
  EXPECT_TRUE(result.courses[0].arrived);
  expect_monotone(result.courses[0]);
}

TEST(LevelSetMorph, ClampedApproachHasOneSpeedFarAway) {
  const LevelSetMorph result = run_level_set_morph(plan_level_set_morph(
      discs({10, 40}), {.profile = ApproachProfile::clamped, .width_pixels = 5, .pacing = FramePacing::time}));
  const double end = result.courses[0].steps.back().time;
  for (const double time : {1.0, 3.0, 5.0})
    EXPECT_LT(off_circle(result.morph.shape_at(time / end), 10 + 5 * time), 0.1) << time;
}

TEST(LevelSetMorph, FramesArePacedAsAsked) {
  const Morph by_area = level_set_morph(discs({10, 30}), {.pacing = FramePacing::volume_fraction});
  const Morph by_rms = level_set_morph(discs({10, 30}), {.pacing = FramePacing::rms_distance});
  for (const double t : {0.25, 0.5, 0.75}) {
    // Areas are counted in pixels: a row of them is a pixel of radius at most.
    EXPECT_LT(off_circle(by_area.shape_at(t), std::sqrt(100 + t * 800)), 0.3) << t;
    EXPECT_LT(off_circle(by_rms.shape_at(t), 10 + 20 * t), 0.3) << t;
  }
}

TEST(LevelSetMorph, EndsWithinHalfAPixelOfTheTargetAndSharesMoreAndMore) {
  const LevelSetMorph result = run_level_set_morph(plan_level_set_morph({x_figure(), o_figure()}, {}));
  expect_monotone(result.courses[0]);
  EXPECT_LT(largest_distance(contours_of(result.morph.shape_at(0)), contours_of(x_figure().shape)), 0.5);
  EXPECT_LT(largest_distance(contours_of(result.morph.shape_at(1)), contours_of(o_figure().shape)), 0.5);
  EXPECT_EQ(frame_quality(result.morph.shape_at(1)).holes, 1u);
}

TEST(LevelSetMorph, ASequenceComesBackToItsFirstShape) {
  const Morph morph = level_set_morph({x_figure(), o_figure(), disc("disc", {40, 50}, 35), x_figure()}, {});
  const auto frames = morph.frames(4);
  EXPECT_LT(largest_distance(contours_of(frames[0]), contours_of(frames[3])), 0.5);
  EXPECT_LT(largest_distance(contours_of(frames[1]), contours_of(o_figure().shape)), 0.5);
  EXPECT_LT(largest_distance(contours_of(frames[2]), contours_of(disc("", {40, 50}, 35).shape)), 0.5);
}

TEST(LevelSetMorph, AFrameDoesNotDependOnWhichOthersAreAskedFor) {
  const Morph morph = level_set_morph({x_figure(), o_figure()}, {});
  EXPECT_EQ(contours_of(morph.frames(5)[2]).front().points_mm, contours_of(morph.shape_at(0.5)).front().points_mm);
}

/// A ball with lobes, a waist and a handle: curvature of all signs, as a scanned animal has.
TriangleMesh bumpy_mesh() {
  TriangleMesh mesh = testing_support::wrapped_mesh(90, 48, [](double u, double v) {
    const double tube = 7 + 1.5 * std::sin(5 * u) + 1 * std::cos(3 * v + 2 * u), ring = 18 + 2 * std::cos(2 * u);
    const double from_axis = ring + tube * std::cos(v);
    return Eigen::Vector3d(from_axis * std::cos(u), 0.8 * from_axis * std::sin(u),
                           tube * std::sin(v) + 3 * std::sin(u));
  });
  mesh.name = "bumpy";
  return mesh;
}

/// Before and after the hole is worn through, and at the end; also of a surface that is nowhere even.
TEST(LevelSetMorph, IsTheSameOnOneAndTwoThreads) {
  const KeyShape ball{.name = "ball", .shape = sphere_mesh({0, 0, 0}, 20, 40, 20)};
  for (const TriangleMesh& target : {torus_mesh(20, 7, 60, 30), bumpy_mesh()}) {
    const auto frames = [&](std::size_t threads) {
      const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
      return level_set_morph({ball, {.name = "target", .shape = target}}, {.resolution_mm = 1.25}).frames(5);
    };
    const auto one = frames(1), two = frames(2);
    for (std::size_t i = 0; i < one.size(); ++i) {
      const auto &a = std::get<TriangleMesh>(one[i]), &b = std::get<TriangleMesh>(two[i]);
      EXPECT_EQ(a.vertices_mm, b.vertices_mm) << target.name << i;
      EXPECT_EQ(a.triangles, b.triangles) << target.name << i;
    }
    EXPECT_EQ(measure(std::get<TriangleMesh>(one.front())).genus, 0);
    EXPECT_EQ(measure(std::get<TriangleMesh>(one.back())).genus, 1);
  }
}

TEST(LevelSetMorph, MeshesThatCrossThemselvesAreRefused) {
  TriangleMesh crossing = sphere_mesh({0, 0, 0}, 20, 40, 20);
  const int count = static_cast<int>(crossing.vertices_mm.size());
  for (int v = 0; v < count; ++v)
    crossing.vertices_mm.push_back(crossing.vertices_mm[static_cast<std::size_t>(v)] + Eigen::Vector3d(15, 0, 0));
  for (std::size_t t = crossing.triangles.size(); t-- > 0;)
    crossing.triangles.emplace_back(crossing.triangles[t].array() + count);
  const KeyShape ball{.name = "ball", .shape = sphere_mesh({0, 0, 0}, 20, 40, 20)};
  EXPECT_THROW(level_set_morph({ball, {.name = "crossing", .shape = crossing}}, {}), InputError);
}

TEST(LevelSetMorph, ABallBecomesATorus) {
  const KeyShape ball{.name = "ball", .shape = sphere_mesh({0, 0, 0}, 20, 40, 20)};
  const KeyShape ring{.name = "ring", .shape = torus_mesh(20, 7, 60, 30)};
  const LevelSetMorph result = run_level_set_morph(plan_level_set_morph({ball, ring}, {.resolution_mm = 1}));
  expect_monotone(result.courses[0]);
  const auto frames = result.morph.frames(5);
  for (const Shape& frame : frames) EXPECT_TRUE(measure(std::get<TriangleMesh>(frame)).watertight());
  EXPECT_EQ(measure(std::get<TriangleMesh>(frames.front())).genus, 0);
  const TriangleMesh& last = std::get<TriangleMesh>(frames.back());
  EXPECT_EQ(measure(last).genus, 1);
  for (const Eigen::Vector3d& v : last.vertices_mm)
    ASSERT_NEAR(std::hypot(std::hypot(v.x(), v.y()) - 20, v.z()), 7, 0.5);
}

KeyShape two_discs() {
  return figure("two", 100, [](const Eigen::Vector2d& p) {
    return 10 - std::min((p - Eigen::Vector2d(30, 50)).norm(), (p - Eigen::Vector2d(70, 50)).norm());
  });
}

TEST(LevelSetMorph, PartsWithoutOverlapAreToldAndMayBeSeeded) {
  const std::vector<KeyShape> shapes{disc("one", {30, 50}, 6), two_discs()};
  const LevelSetPlan plan = plan_level_set_morph(shapes, {});
  ASSERT_EQ(plan.unshared.size(), 1u);
  EXPECT_EQ(plan.unshared[0].from, "one");
  EXPECT_EQ(plan.unshared[0].to, "two");
  EXPECT_FALSE(plan.unshared[0].is_hollow);
  EXPECT_LT((plan.unshared[0].place_mm - Eigen::Vector3d(70, 50, 0)).norm(), 1);
  EXPECT_NEAR(plan.unshared[0].content, 100 * std::numbers::pi, 10);  // the pixels of a disc
  EXPECT_EQ(contours_of(run_level_set_morph(plan).morph.shape_at(1)).size(), 1u);

  const Morph seeded = level_set_morph(shapes, {.unshared = UnsharedParts::seed});
  EXPECT_LT(largest_distance(contours_of(seeded.shape_at(1)), contours_of(two_discs().shape)), 0.5);
}

TEST(LevelSetMorph, HollowsThatAreFilledAreToldAndMayBeSeeded) {
  const std::vector<KeyShape> shapes{disc("disc", {50, 50}, 35), o_figure()};
  const LevelSetPlan plan = plan_level_set_morph(shapes, {});
  ASSERT_EQ(plan.unshared.size(), 1u);
  EXPECT_TRUE(plan.unshared[0].is_hollow);
  const Morph seeded = level_set_morph(shapes, {.unshared = UnsharedParts::seed});
  EXPECT_LT(largest_distance(contours_of(seeded.shape_at(1)), contours_of(o_figure().shape)), 0.5);
}

TEST(LevelSetMorph, ShapesApartAreRefusedUnlessMovedOrSeeded) {
  const std::vector<KeyShape> shapes{disc("left", {25, 50}, 10), disc("right", {75, 50}, 10)};
  EXPECT_THROW(level_set_morph(shapes, {}), InputError);
  const Morph moving = level_set_morph(shapes, {.transform = TransformKind::rigid});
  EXPECT_LT(largest_distance(contours_of(moving.shape_at(0.5)), contours_of(disc("", {50, 50}, 10).shape)), 0.5);
  const Morph seeded = level_set_morph(shapes, {.unshared = UnsharedParts::seed});
  EXPECT_LT(largest_distance(contours_of(seeded.shape_at(1)), contours_of(shapes[1].shape)), 0.5);
}

TEST(LevelSetMorph, ARigidTransformTurnsAShapeRatherThanMeltingIt) {
  // An egg-shaped figure and itself turned by 1 rad: every frame is the figure turned.
  const KeyShape egg = figure("egg", 100, [](const Eigen::Vector2d& p) {
    const Eigen::Vector2d q = p - Eigen::Vector2d(50, 50);
    return 1 - std::hypot(q.x() / (q.x() > 0 ? 35 : 22), q.y() / 15);
  });
  const Eigen::Vector2d centre(50, 50);
  const auto turned = [&](double angle) { return moved(egg, angle, centre - Eigen::Rotation2Dd(angle) * centre); };
  const Morph morph = level_set_morph({egg, turned(1)}, {.transform = TransformKind::rigid});
  EXPECT_LT(largest_distance(contours_of(morph.shape_at(1)), contours_of(turned(1).shape)), 0.5);
  // The mass' centre goes straight, the figure's own centre beside it does not.
  const auto area = [](const Shape& shape) { return frame_quality(shape).content; };
  EXPECT_NEAR(area(morph.shape_at(0.5)), area(egg.shape), 0.005 * area(egg.shape));  // a tenth of a pixel all round
}

TEST(LevelSetMorph, AWarpTakesLandmarksAlong) {
  const std::vector<LandmarkPair> landmarks{
      {{25, 50, 0}, {45, 50, 0}}, {{25, 60, 0}, {45, 60, 0}}, {{35, 50, 0}, {55, 50, 0}}};
  const std::vector<KeyShape> shapes{disc("left", {25, 50}, 10), disc("right", {45, 50}, 10)};
  for (const TransformKind kind : {TransformKind::rigid, TransformKind::affine, TransformKind::warp}) {
    const Morph morph = level_set_morph(shapes, {.transform = kind, .landmarks = landmarks});
    EXPECT_LT(largest_distance(contours_of(morph.shape_at(0.5)), contours_of(disc("", {35, 50}, 10).shape)), 0.5);
  }
  EXPECT_THROW(level_set_morph(shapes, {.transform = TransformKind::warp}), InputError);
  EXPECT_THROW(level_set_morph(shapes, {.transform = TransformKind::affine, .landmarks = {landmarks[0], landmarks[1]}}),
               InputError);
}

TEST(LevelSetMorph, NodesBeyondTheMemoryAllowedAreRefused) {
  const KeyShape ball{.name = "ball", .shape = sphere_mesh({0, 0, 0}, 20, 40, 20)};
  EXPECT_THROW(level_set_morph({ball, ball}, {.resolution_mm = 1e-3}), SolveError);
}

}  // namespace
}  // namespace isostack

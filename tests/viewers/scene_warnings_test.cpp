#include "viewers/scene_warnings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "viewers/scene_points.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;

const Eigen::Vector3d centre_mm(60, -40, 100);

TriangleMesh ball(const Eigen::Vector3d& centre, double radius_mm) {
  TriangleMesh mesh = sphere_mesh(centre, radius_mm, 48, 24);
  mesh.name = "ball";
  return mesh;
}

ContourStack rings_of_ball(double radius_mm) {
  ContourStack stack{.name = "ball", .slices = {}};
  for (double z = -20; z <= 20; z += 10) {
    ContourSlice slice;
    slice.pose.origin_mm = centre_mm + Eigen::Vector3d(0, 0, z);
    Contour contour;
    for (int i = 0; i < 90; ++i)
      contour.points_mm.push_back(
          std::sqrt(radius_mm * radius_mm - z * z) *
          Eigen::Vector2d(std::cos(i * std::numbers::pi / 45), std::sin(i * std::numbers::pi / 45)));
    slice.contours = {contour};
    stack.slices.push_back(slice);
  }
  return stack;
}

Slice slice_round_ball() {
  Slice slice{.name = "slice", .pose = {}, .pixels = Image<float>::Zero(100, 100)};
  slice.pose.origin_mm = centre_mm - Eigen::Vector3d(50, 50, 30);
  return slice;
}

Scene beside_contours(const TriangleMesh& mesh) {
  return {.surfaces = {{.mesh = mesh}}, .contours = {{.stack = rings_of_ball(30)}}};
}

Scene beside_slices(const TriangleMesh& mesh) {
  Scene scene{.surfaces = {{.mesh = mesh}}, .slices = {{.image = slice_round_ball()}, {.image = slice_round_ball()}}};
  scene.slices[1].image.pose.origin_mm.z() += 60;
  return scene;
}

std::string only_warning(const Scene& scene) {
  const std::vector<std::string> warnings = scene_warnings(scene);
  return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
}

TEST(SceneWarnings, SayNothingWhereAllIsWell) {
  EXPECT_TRUE(scene_warnings(beside_contours(ball(centre_mm, 30))).empty());
  EXPECT_TRUE(scene_warnings(beside_slices(ball(centre_mm, 30))).empty());
  EXPECT_TRUE(scene_warnings({.surfaces = {{.mesh = ball(centre_mm, 30)}}}).empty());
  // Another organ than that of the contours, in the same patient.
  EXPECT_TRUE(scene_warnings(beside_contours(ball(centre_mm, 90))).empty());
}

TEST(SceneWarnings, TellAMeshInMetres) {
  for (const Scene& scene :
       {beside_contours(ball(centre_mm / 1000, 0.030)), beside_slices(ball(centre_mm / 1000, 0.030)),
        Scene{.surfaces = {{.mesh = ball(centre_mm / 1000, 0.030)}}}})
    EXPECT_NE(only_warning(scene).find("metres"), std::string::npos) << only_warning(scene);
}

TEST(SceneWarnings, TellAMeshInRas) {
  const Eigen::Vector3d in_ras(-centre_mm.x(), -centre_mm.y(), centre_mm.z());
  for (const Scene& scene : {beside_contours(ball(in_ras, 30)), beside_slices(ball(in_ras, 30))})
    EXPECT_NE(only_warning(scene).find("--input-axes ras"), std::string::npos) << only_warning(scene);
}

TEST(SceneWarnings, TellAMeshThatIsElsewhere) {
  for (const Scene& scene : {beside_contours(ball({500, 0, 0}, 30)), beside_slices(ball({500, 0, 0}, 30))})
    EXPECT_NE(only_warning(scene).find("same scan"), std::string::npos) << only_warning(scene);
}

TEST(RequireDrawable, RefusesNothingAndWhatIsNoNumber) {
  EXPECT_THROW(require_drawable({}), InputError);
  EXPECT_THROW(require_drawable({.marks = {{.to_mm = {1, 1, 1}}}}), InputError);  // a mark of nothing
  Scene scene = beside_contours(ball(centre_mm, 30));
  EXPECT_NO_THROW(require_drawable(scene));
  scene.contours[0].stack.slices[2].contours[0].points_mm[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(require_drawable(scene), InputError);
  scene = beside_contours(ball(centre_mm, 30));
  scene.surfaces[0].values = VertexValues{.label = "", .values = {1, 2, 3}};
  EXPECT_THROW(require_drawable(scene), InputError);
}

}  // namespace
}  // namespace isostack

#include "recon/geometry/slice_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

/// A sagittal slice: columns run towards posterior (+y), rows towards the feet (−z).
SlicePose sagittal() {
  return {.origin_mm = {10, 20, 30}, .x_axis = {0, 1, 0}, .y_axis = {0, 0, -1}, .spacing_mm = {0.5, 2}};
}

SlicePose oblique() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return {.origin_mm = {-4, 5, 60}, .x_axis = turn.col(0), .y_axis = turn.col(1), .spacing_mm = {0.7, 1.3}};
}

TEST(SlicePose, PlacesPixelsOfASagittalSlice) {
  const SlicePose pose = sagittal();
  EXPECT_TRUE(pose.pixel_to_world({0, 0}).isApprox(Eigen::Vector3d(10, 20, 30)));
  EXPECT_TRUE(pose.pixel_to_world({4, 3}).isApprox(Eigen::Vector3d(10, 22, 24)));  // column 4, row 3
  EXPECT_TRUE(pose.pixel_to_slice({4, 3}).isApprox(Eigen::Vector2d(2, 6)));
}

TEST(SlicePose, NormalIsColumnsCrossRows) { EXPECT_TRUE(sagittal().normal().isApprox(Eigen::Vector3d(-1, 0, 0))); }

TEST(SlicePose, DistanceIsPositiveOnTheNormalsSide) {
  EXPECT_DOUBLE_EQ(sagittal().signed_distance_mm({7, 100, -50}), 3);
  EXPECT_DOUBLE_EQ(sagittal().signed_distance_mm({12, 0, 0}), -2);
}

TEST(SlicePose, FramesRoundTrip) {
  const SlicePose pose = oblique();
  const Eigen::Vector2d pixel(17.25, -3.5);
  const Eigen::Vector3d world = pose.pixel_to_world(pixel);
  EXPECT_LT((pose.slice_to_pixel(pose.world_to_slice(world)) - pixel).norm(), 1e-12);
  EXPECT_NEAR(pose.signed_distance_mm(world), 0, 1e-12);
}

TEST(SlicePose, WorldToSliceProjectsAlongTheNormal) {
  const SlicePose pose = oblique();
  const Eigen::Vector3d above = pose.slice_to_world({3, 4}) + 25 * pose.normal();
  EXPECT_LT((pose.world_to_slice(above) - Eigen::Vector2d(3, 4)).norm(), 1e-12);
  EXPECT_NEAR(pose.signed_distance_mm(above), 25, 1e-12);
}

TEST(CheckedPose, OrthonormalisesWhatRoundingInAHeaderLeft) {
  SlicePose pose = oblique();
  const SlicePose exact = pose;
  pose.x_axis += Eigen::Vector3d(3e-4, -2e-4, 1e-4);
  pose.y_axis *= 1 + 5e-4;
  const SlicePose checked = checked_pose(pose, "a.dcm");
  EXPECT_NEAR(checked.x_axis.norm(), 1, 1e-14);
  EXPECT_NEAR(checked.y_axis.norm(), 1, 1e-14);
  EXPECT_NEAR(checked.x_axis.dot(checked.y_axis), 0, 1e-14);
  EXPECT_LT((checked.normal() - exact.normal()).norm(), 1e-3);  // not turned by more than it was off
}

TEST(CheckedPose, RefusesWhatIsNoPose) {
  const auto message_of = [](SlicePose pose) -> std::string {
    try {
      checked_pose(pose, "slice 7");
    } catch (const GeometryError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_of(sagittal()), "");
  SlicePose skewed = sagittal(), stretched = sagittal(), flat = sagittal(), unplaced = sagittal(),
            negative = sagittal(), remote = sagittal();
  skewed.y_axis = Eigen::Vector3d(0, 0.01, -1).normalized();
  stretched.x_axis *= 1.01;
  flat.spacing_mm.x() = 0;
  negative.spacing_mm.y() = -1;
  unplaced.origin_mm.z() = std::numeric_limits<double>::quiet_NaN();
  remote.origin_mm.x() = 1e300;
  for (const SlicePose& pose : {skewed, stretched, flat, negative, unplaced, remote})
    EXPECT_EQ(message_of(pose).rfind("slice 7: ", 0), 0u) << message_of(pose);
}

TEST(AreParallel, IgnoresSignAndPlaceButNotAngle) {
  const SlicePose pose = oblique();
  SlicePose reversed = pose, turned = pose;
  reversed.y_axis *= -1;
  reversed.origin_mm += Eigen::Vector3d(1, 2, 3);
  EXPECT_TRUE(are_parallel(pose, reversed));
  turned.x_axis = Eigen::AngleAxisd(0.01, pose.y_axis) * pose.x_axis;
  EXPECT_FALSE(are_parallel(pose, turned));
  EXPECT_TRUE(are_parallel(pose, turned, 0.011));
}

}  // namespace
}  // namespace isostack

#include "recon/constraints/align.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/support/crossing_slices.h"

namespace isostack {
namespace {

using testing_support::cardiac_slices;
using testing_support::orthogonal_slices;

const Eigen::Vector2d three_mm(2.4, -1.8);

ContourStack with_moved_contour(ContourStack stack, std::size_t slice, const Eigen::Isometry2d& motion) {
  for (Eigen::Vector2d& p : stack.slices[slice].contours[0].points_mm) p = motion * p;
  return stack;
}

/// Farthest that a slice other than `moved` went.
double others_mm(const Alignment& alignment, std::size_t moved) {
  double farthest = 0;
  for (std::size_t s = 0; s < alignment.motions.size(); ++s)
    if (s != moved) farthest = std::max(farthest, alignment.motions[s].shift_mm.norm());
  return farthest;
}

TEST(Align, OneMovedSliceComesBackAndTheOthersStay) {
  for (const ContourStack& stack : {orthogonal_slices(), cardiac_slices()})
    for (std::size_t s = 0; s < stack.slices.size(); ++s) {
      const Alignment found =
          align_slices(with_moved_contour(stack, s, Eigen::Isometry2d(Eigen::Translation2d(three_mm))));
      EXPECT_LT((found.motions[s].shift_mm + three_mm).norm(), 0.3) << stack.slices[s].name;
      EXPECT_LT(others_mm(found, s), 0.3) << stack.slices[s].name;
      EXPECT_LT(found.after.disagreement_mm(), 0.1 * found.before.disagreement_mm());
    }
}

TEST(Align, NothingToAlignMovesNothing) {
  for (const bool rotation : {false, true})
    for (const ContourStack& stack : {orthogonal_slices(), cardiac_slices()})
      for (const InPlaneMotion& motion : align_slices(stack, {.rotation = rotation}).motions) {
        EXPECT_LT(motion.shift_mm.norm(), 0.05);
        EXPECT_LT(std::abs(motion.rotation_rad), 0.002);  // 0.05 mm at the contours
      }
}

TEST(Align, ATurnedSliceTurnsBack) {
  const ContourStack stack = orthogonal_slices();
  const double turn_rad = 5 * std::numbers::pi / 180;
  const Alignment found =
      align_slices(with_moved_contour(stack, 1, Eigen::Isometry2d(Eigen::Rotation2Dd(turn_rad))), {.rotation = true});
  EXPECT_NEAR(found.motions[1].rotation_rad, -turn_rad, 0.01);  // 0.3 mm at the contours
  EXPECT_LT(others_mm(found, 1), 0.3);
}

TEST(Align, TheLimitHolds) {
  const ContourStack stack =
      with_moved_contour(orthogonal_slices(), 5, Eigen::Isometry2d(Eigen::Translation2d(three_mm)));
  for (const InPlaneMotion& motion : align_slices(stack, {.max_shift_mm = 1}).motions)
    EXPECT_LE(motion.shift_mm.norm(), 1 + 1e-9);
}

TEST(Align, MovedPosesStayInTheirPlanes) {
  const ContourStack stack =
      with_moved_contour(orthogonal_slices(), 5, Eigen::Isometry2d(Eigen::Translation2d(three_mm)));
  const Alignment found = align_slices(stack, {.rotation = true});
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const SlicePose &was = stack.slices[s].pose, &now = found.stack.slices[s].pose;
    EXPECT_LT(was.normal().cross(now.normal()).norm(), 1e-9);
    EXPECT_NEAR(was.signed_distance_mm(now.origin_mm), 0, 1e-9);
    EXPECT_EQ(stack.slices[s].contours[0].points_mm, found.stack.slices[s].contours[0].points_mm);
  }
}

TEST(Align, TheMotionTurnsAboutTheGivenPoint) {
  SlicePose pose;
  pose.origin_mm = {5, 6, 7};
  const InPlaneMotion motion{.shift_mm = {1, 2}, .rotation_rad = std::numbers::pi / 2};
  const SlicePose moved = moved_in_plane(pose, motion, {10, 0});
  EXPECT_LT((moved.slice_to_world({10, 0}) - Eigen::Vector3d(16, 8, 7)).norm(), 1e-12);  // the middle only shifts
  EXPECT_LT((moved.slice_to_world({11, 0}) - Eigen::Vector3d(16, 9, 7)).norm(), 1e-12);  // x turned to y
}

TEST(Align, ParallelSlicesHaveNothingToAlign) {
  ContourStack stack = orthogonal_slices();
  stack.slices.resize(4);
  EXPECT_EQ(others_mm(align_slices(stack), stack.slices.size()), 0);
}

}  // namespace
}  // namespace isostack

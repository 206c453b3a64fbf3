#include "io/stack_geometry.h"

#include "io/slice_order.h"
#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

std::vector<SlicePose> poses_of(const SliceStack& stack) {
  std::vector<SlicePose> poses;
  for (const Slice& slice : stack.slices) poses.push_back(slice.pose);
  return poses;
}

std::vector<std::string> warnings_for(const SliceStack& stack, const ClaimedDistances& claimed = {}) {
  std::vector<std::string> names;
  for (const Slice& slice : stack.slices) names.push_back(slice.name);
  return geometry_warnings(analyse_stack(poses_of(stack)), names, claimed);
}

TEST(SliceOrder, GoesAlongTheNormal) {
  EXPECT_EQ(order_along_normals(poses_of(oblique_stack({4, -2, 0, 9}))), (std::vector<std::size_t>{1, 2, 0, 3}));
}

TEST(SliceOrder, KeepsDirectionsTogether) {
  std::vector<SlicePose> poses = poses_of(oblique_stack({4, 0}));
  SlicePose other = poses.front();
  std::swap(other.y_axis, other.x_axis);
  other.y_axis = poses.front().normal();
  poses.insert(poses.begin() + 1, other);
  EXPECT_EQ(order_along_normals(poses), (std::vector<std::size_t>{2, 0, 1}));
  EXPECT_EQ(analyse_stack({poses[2], poses[0], poses[1]}).orientations, 2);
}

TEST(SliceOrder, FlippedNormalStaysInTheSameDirection) {
  std::vector<SlicePose> poses = poses_of(oblique_stack({4, 0, 2}));
  poses[2].x_axis *= -1;
  EXPECT_EQ(order_along_normals(poses), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(StackGeometry, EvenStackGivesNoWarning) {
  const SliceStack stack = oblique_stack({0, 2.5, 5, 7.5});
  const StackGeometry geometry = analyse_stack(poses_of(stack));
  ASSERT_EQ(geometry.gaps.size(), 3u);
  for (const SliceGap& gap : geometry.gaps) EXPECT_NEAR(gap.mm, 2.5, 1e-12);  // rounding of doubles
  EXPECT_NEAR(geometry.tilt_deg, 0, 1e-6);                                    // acos-free, so only rounding
  EXPECT_TRUE(warnings_for(stack, {2.5, 2.5}).empty());
}

TEST(StackGeometry, TiltIsTheAngleOfTheSteps) {
  const StackGeometry geometry = analyse_stack(poses_of(oblique_stack({0, 3, 6}, {0, std::tan(0.25)})));
  EXPECT_NEAR(geometry.tilt_deg, 0.25 * 180 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(geometry.gaps.front().mm, 3, 1e-12);  // the gap is along the normal, not along the step
}

TEST(StackGeometry, MissingSliceIsNamedBetweenItsNeighbours) {
  const auto warnings = warnings_for(oblique_stack({0, 2, 4, 8, 10}));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(warnings[0].starts_with("uneven gaps: 3 x 2.00 mm, 1 x 4.00 mm")) << warnings[0];
  EXPECT_NE(warnings[1].find("4.00 mm between slice 3 and slice 4 is 2 times the usual 2.00 mm"), std::string::npos)
      << warnings[1];
}

TEST(StackGeometry, OtherGapsAreUnevenButNotMissing) {
  const auto warnings = warnings_for(oblique_stack({0, 2, 4, 7.1}));
  EXPECT_TRUE(has_warning(warnings, "uneven gaps: "));
  EXPECT_FALSE(has_warning(warnings, "missing slices: "));
}

TEST(StackGeometry, HeadersAreComparedWithPositions) {
  const SliceStack stack = oblique_stack({0, 2, 4});
  EXPECT_TRUE(has_warning(warnings_for(stack, {3.0, std::nullopt}), "overlapping slices: they are 3.00 mm thick"));
  EXPECT_TRUE(has_warning(warnings_for(stack, {std::nullopt, 5.0}), "differing spacing: the header says 5.00 mm"));
  EXPECT_TRUE(warnings_for(stack, {1.0, 2.0}).empty());
}

}  // namespace
}  // namespace isostack::testing

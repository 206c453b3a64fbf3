#include "viewers/window/contour_edit.h"

#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;

constexpr double radius_mm = 10;

/// Three slices, each with a circle of 36 points about its origin.
std::vector<ContourStack> three_circles() {
  return {testing_support::sphere_cuts(radius_mm, {}, {-1e-3, 0, 1e-3}, 36)};
}

const std::vector<Eigen::Vector2d>& points_of(const ContourEdits& edits, std::size_t slice) {
  return edits.organs()[0].slices[slice].contours[0].points_mm;
}

TEST(ContourEdits, MovesOnePoint) {
  ContourEdits edits(three_circles());
  edits.apply({{.kind = EditKind::move_point, .slice = 1, .point = 0, .to_mm = {12, 1}}});
  EXPECT_EQ(points_of(edits, 1)[0], Eigen::Vector2d(12, 1));
  EXPECT_EQ(points_of(edits, 1)[1], three_circles()[0].slices[1].contours[0].points_mm[1]);
  EXPECT_EQ(points_of(edits, 0), three_circles()[0].slices[0].contours[0].points_mm);
}

TEST(ContourEdits, NeighboursWithinReachFollowLessTheFartherTheyAre) {
  ContourEdits edits(three_circles());
  // Points are 1.743 mm apart along the curve: reach takes two neighbours on either side.
  edits.apply({{.kind = EditKind::move_point, .slice = 1, .point = 0, .to_mm = {12, 0}, .reach_mm = 4}});
  const auto before = three_circles()[0].slices[1].contours[0].points_mm;
  const double apart_mm = (before[1] - before[0]).norm();
  for (const int k : {1, 2, 35, 34}) {
    const double walked_mm = apart_mm * std::min(k, 36 - k);
    const Eigen::Vector2d shift =
        points_of(edits, 1)[static_cast<std::size_t>(k)] - before[static_cast<std::size_t>(k)];
    EXPECT_NEAR(shift.x(), 2 * (1 + std::cos(std::numbers::pi * walked_mm / 4)) / 2, 1e-12) << k;
    EXPECT_NEAR(shift.y(), 0, 1e-12);
  }
  EXPECT_EQ(points_of(edits, 1)[3], before[3]);
  EXPECT_EQ(points_of(edits, 1)[33], before[33]);
}

TEST(ContourEdits, AddsAndDeletesPoints) {
  ContourEdits edits(three_circles());
  edits.apply({{.kind = EditKind::add_point, .slice = 0, .point = 1, .to_mm = {10.5, 0.9}}});
  ASSERT_EQ(points_of(edits, 0).size(), 37U);
  EXPECT_EQ(points_of(edits, 0)[1], Eigen::Vector2d(10.5, 0.9));
  edits.apply({{.kind = EditKind::add_point, .slice = 0, .point = 37, .to_mm = {10.5, -0.9}}});  // after the last
  EXPECT_EQ(points_of(edits, 0).back(), Eigen::Vector2d(10.5, -0.9));
  edits.apply({{.kind = EditKind::delete_point, .slice = 0, .point = 1}});
  EXPECT_EQ(points_of(edits, 0)[1], three_circles()[0].slices[0].contours[0].points_mm[1]);
}

TEST(ContourEdits, DroppedSlicesAreLeftOutOfWhatIsSolved) {
  ContourEdits edits(three_circles());
  edits.apply({{.kind = EditKind::drop_slice, .slice = 1}});
  EXPECT_TRUE(edits.is_dropped(0, 1));
  EXPECT_EQ(edits.organs()[0].slices.size(), 3U);
  const std::vector<ContourStack> kept = edits.kept_organs();
  ASSERT_EQ(kept[0].slices.size(), 2U);
  EXPECT_EQ(kept[0].slices[1].name, three_circles()[0].slices[2].name);
  EXPECT_THROW(edits.apply({{.kind = EditKind::delete_point, .slice = 1, .point = 0}}), GeometryError);
}

TEST(ContourEdits, UndoAndRedoGiveBackEveryState) {
  ContourEdits edits(three_circles());
  std::vector<std::vector<Eigen::Vector2d>> states = {points_of(edits, 2)};
  for (const double x : {10.5, 11.0, 11.5}) {
    edits.apply({{.kind = EditKind::add_point, .slice = 2, .point = 1, .to_mm = {x, 0.8}},
                 {.kind = EditKind::move_point, .slice = 2, .point = 1, .to_mm = {x, 0.9}, .reach_mm = 0}});
    states.push_back(points_of(edits, 2));
  }
  EXPECT_EQ(edits.steps().size(), 3U);
  for (int k = 2; k >= 0; --k) {
    EXPECT_TRUE(edits.undo());
    EXPECT_EQ(points_of(edits, 2), states[static_cast<std::size_t>(k)]);
  }
  EXPECT_FALSE(edits.undo());
  for (std::size_t k = 1; k <= 3; ++k) {
    EXPECT_TRUE(edits.redo());
    EXPECT_EQ(points_of(edits, 2), states[k]);
  }
  EXPECT_FALSE(edits.redo());
  edits.undo();
  edits.apply({{.kind = EditKind::drop_slice, .slice = 0}});
  EXPECT_FALSE(edits.can_redo()) << "a new step forgets what was undone";
  edits.undo();
  EXPECT_FALSE(edits.is_dropped(0, 0));
}

TEST(ContourEdits, RefusalsChangeNothing) {
  ContourEdits edits(three_circles());
  const auto before = points_of(edits, 0);
  // The first edit of the step is sound, the second drags a point through the opposite side.
  const EditStep crossing = {{.kind = EditKind::add_point, .slice = 0, .point = 1, .to_mm = {10.5, 0.9}},
                             {.kind = EditKind::move_point, .slice = 0, .point = 1, .to_mm = {-15, 0.3}}};
  EXPECT_THROW(edits.apply(crossing), GeometryError);
  EXPECT_EQ(points_of(edits, 0), before);
  EXPECT_TRUE(edits.steps().empty());
  EXPECT_THROW(edits.apply({{.kind = EditKind::move_point, .slice = 0, .point = 36}}), InputError);
  EXPECT_THROW(edits.apply({{.kind = EditKind::add_point, .slice = 0, .point = 0}}), InputError);
  EXPECT_THROW(edits.apply({{.kind = EditKind::drop_slice, .slice = 3}}), InputError);
  EXPECT_THROW(edits.apply({{.kind = EditKind::drop_slice, .organ = 1}}), InputError);
  EXPECT_THROW(edits.apply({{.kind = EditKind::move_point, .slice = 0, .point = 0, .to_mm = {NAN, 0}}}), InputError);
}

TEST(ContourEdits, ATriangleKeepsItsPoints) {
  ContourStack stack = testing_support::sphere_cuts(radius_mm, {}, {0}, 3);
  ContourEdits edits({stack});
  EXPECT_THROW(edits.apply({{.kind = EditKind::delete_point, .point = 0}}), GeometryError);
}

TEST(NearestPoint, OfVerticesAndOfEdges) {
  const std::vector<Contour> contours = {circle({0, 0}, radius_mm, 4), circle({30, 0}, radius_mm, 4)};
  const NearestPoint vertex = nearest_point(contours, {30, 11}, false);
  EXPECT_EQ(vertex.contour, 1U);
  EXPECT_EQ(vertex.point, 1U);  // at (30, 10)
  EXPECT_NEAR(vertex.distance_mm, 1, 1e-12);
  // The middle of the edge from (10, 0) to (0, 10).
  const NearestPoint edge = nearest_point(contours, {5, 5}, true);
  EXPECT_EQ(edge.contour, 0U);
  EXPECT_EQ(edge.point, 1U);
  EXPECT_NEAR(edge.distance_mm, 0, 1e-12);
  EXPECT_TRUE(std::isinf(nearest_point({}, {0, 0}, true).distance_mm));
}

}  // namespace
}  // namespace isostack

#include "recon/geometry/self_crossing.h"

#include <gtest/gtest.h>

namespace isostack {
namespace {

TEST(SelfCrossing, FindsTheMiddleOfAnEight) {
  const auto point = self_crossing({.points_mm = {{0, 0}, {4, 4}, {4, 0}, {0, 4}}});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->x(), 2, 1e-12);  // the diagonals of a square of 4 mm
  EXPECT_NEAR(point->y(), 2, 1e-12);
}

TEST(SelfCrossing, SimpleCurvesHaveNone) {
  EXPECT_FALSE(self_crossing({.points_mm = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_FALSE(self_crossing({.points_mm = {{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}}}));
}

TEST(SelfCrossing, KeyholesTouchButDoNotCross) {
  // A square with a square hole reached along one edge that is walked twice.
  EXPECT_FALSE(self_crossing(
      {.points_mm = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 4}, {3, 4}, {3, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 4}, {0, 4}}}));
}

}  // namespace
}  // namespace isostack

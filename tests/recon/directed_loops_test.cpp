#include "recon/subdivision/directed_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace isostack {
namespace {

/// Counter-clockwise, or with `hole` clockwise.
Contour square(double x, double y, double side, bool hole = false) {
  Contour contour{.points_mm = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}};
  if (hole) std::reverse(contour.points_mm.begin(), contour.points_mm.end());
  return contour;
}

double area(const std::vector<Contour>& contours) {
  double sum = 0;
  for (const Contour& contour : contours) sum += signed_area_mm2(contour);
  return sum;
}

TEST(DirectedLoops, ThatAreAFigureStayAsTheyAre) {
  const std::vector<Contour> figure = figure_of({square(0, 0, 10), square(2, 2, 6, true), square(4, 4, 2)});
  ASSERT_EQ(figure.size(), 3U);
  EXPECT_EQ(area(figure), 100 - 36 + 4);
  EXPECT_EQ(figure[2].depth, 2);
}

TEST(DirectedLoops, DropAHoleThatHasLeftItsFigure) {
  const std::vector<Contour> figure = figure_of({square(0, 0, 10), square(20, 2, 4, true)});
  ASSERT_EQ(figure.size(), 1U);
  EXPECT_EQ(area(figure), 100);
}

TEST(DirectedLoops, DropALoopWithinAnotherThatChangesNothing) {
  EXPECT_EQ(area(figure_of({square(0, 0, 10), square(2, 2, 3)})), 100);
}

// Crossings are cut to simple_loops()' 0.005 mm, along at most 20 mm.
constexpr double cut_mm2 = 0.1;

TEST(DirectedLoops, CutAHoleThatCrossesTheEdge) {
  const std::vector<Contour> figure = figure_of({square(0, 0, 10), square(8, 3, 4, true)});
  EXPECT_NEAR(area(figure), 100 - 2 * 4, cut_mm2);
  EXPECT_FALSE(is_inside(figure, {11, 5}));
}

TEST(DirectedLoops, UniteOuterLoopsThatCross) {
  const std::vector<Contour> figure = figure_of({square(0, 0, 10), square(8, 3, 6)});
  EXPECT_NEAR(area(figure), 100 + 36 - 2 * 6, cut_mm2);
  EXPECT_TRUE(is_inside(figure, {9, 5}));
}

}  // namespace
}  // namespace isostack

#include "recon/geometry/shortest_tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "recon/geometry/contour.h"
#include "recon/geometry/self_crossing.h"

namespace isostack {
namespace {

/// A crescent: the outer arc of one circle and the inner arc of another, which no order by angle gets right.
std::vector<Eigen::Vector2d> crescent() {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = std::numbers::pi * i / 60.0;
    points.emplace_back(30 * std::cos(angle), 30 * std::sin(angle));
    if (i % 2 == 0) points.emplace_back(24 * std::cos(angle), 21 * std::sin(angle));
  }
  return points;
}

TEST(ShortestTour, GoesRoundACrescentWhateverTheOrderOfItsPoints) {
  std::vector<Eigen::Vector2d> points = crescent();
  const std::vector<Eigen::Vector2d> first = shortest_tour(points);
  const Contour contour{.points_mm = first};
  EXPECT_FALSE(self_crossing(contour));
  // half the outer circle less half the inner ellipse; chords of 60 and 30 pieces miss less than 1 % of either
  const double area_mm2 = std::numbers::pi / 2 * (30 * 30 - 24 * 21);
  EXPECT_NEAR(std::abs(signed_area_mm2(contour)), area_mm2, 8);
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  EXPECT_EQ(shortest_tour(points), first);
}

TEST(ShortestTour, ClosesAnOpenCurveStraight) {
  std::vector<Eigen::Vector2d> points;  // a U, 20 wide and 40 deep
  for (int i = 0; i <= 40; ++i) {
    points.emplace_back(0, i);
    points.emplace_back(20, i);
  }
  for (int i = 1; i < 20; ++i) points.emplace_back(i, 0);
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  const Contour contour{.points_mm = shortest_tour(points)};
  EXPECT_NEAR(std::abs(signed_area_mm2(contour)), 800, 1e-9);
  EXPECT_NEAR(perimeter_mm(contour), 120, 1e-9);
}

TEST(ShortestTour, KeepsEveryPointAlsoCoincidingOnes) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}};
  EXPECT_EQ(shortest_tour(points).size(), points.size());
  EXPECT_EQ(shortest_tour({}).size(), 0u);
}

}  // namespace
}  // namespace isostack

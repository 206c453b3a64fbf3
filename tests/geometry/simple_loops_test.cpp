#include "recon/geometry/simple_loops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "recon/geometry/self_crossing.h"

namespace isostack {
namespace {

// Places nearer than 0.005 mm may become one: area changes by at most that times the perimeter, here below 100 mm.
constexpr double area_tolerance_mm2 = 0.5;

Contour rectangle(double left, double low, double right, double high) {
  return {{{left, low}, {right, low}, {right, high}, {left, high}}, 0};
}

Contour circle(const Eigen::Vector2d& centre, double radius_mm, int points) {
  Contour contour;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    contour.points_mm.push_back(centre + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return contour;
}

double area_mm2(const std::vector<Contour>& contours) {
  double sum = 0;
  for (const Contour& contour : contours) sum += signed_area_mm2(contour);
  return sum;
}

/// Outer circle of radius 10, then along a channel to a square hole of side 4 and back.
Contour keyhole(double channel_offset_mm = 0) {
  Contour contour = circle({0, 0}, 10, 60);
  contour.points_mm.push_back({10, 0});
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(2, 0), Eigen::Vector2d(2, -2), Eigen::Vector2d(-2, -2),
                                        Eigen::Vector2d(-2, 2), Eigen::Vector2d(2, 2), Eigen::Vector2d(2, 0)})
    contour.points_mm.push_back(corner);
  contour.points_mm.back().y() += channel_offset_mm;
  return contour;
}

TEST(SimpleLoops, LoopsWithoutTroubleComeBackAsTheyAre) {
  const std::vector<Contour> given = {circle({0, 0}, 10, 100), circle({0, 0}, 6, 50), circle({30, 0}, 3, 5)};
  const std::vector<Contour> loops = simple_loops(given);
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[0].points_mm, given[0].points_mm);
  EXPECT_EQ(loops[2].points_mm, given[2].points_mm);
  EXPECT_EQ(loops[1].depth, 1);
  EXPECT_LT(signed_area_mm2(loops[1]), 0);
}

TEST(SimpleLoops, AKeyholeIsAnOuterLoopAndAHole) {
  for (const double rounding_mm : {0.0, 0.004}) {
    const std::vector<Contour> loops = simple_loops({keyhole(rounding_mm)});
    ASSERT_EQ(loops.size(), 2u);
    const auto& outer = loops[0].depth == 0 ? loops[0] : loops[1];
    const auto& hole = loops[0].depth == 0 ? loops[1] : loops[0];
    EXPECT_EQ(outer.points_mm.size(), 60u);
    EXPECT_EQ(hole.points_mm.size(), 5u);  // four corners and the channel's end
    EXPECT_NEAR(signed_area_mm2(hole), -16, area_tolerance_mm2);
    EXPECT_FALSE(is_inside(loops, {0, 0}));
    EXPECT_TRUE(is_inside(loops, {6, 0.1}));
  }
}

TEST(SimpleLoops, AChannelWithUnequalPointsOnItsSidesIsStillOne) {
  Contour contour = keyhole();
  contour.points_mm.insert(contour.points_mm.end(), {{4, 0}, {7, 0}});  // only on the way back
  const std::vector<Contour> loops = simple_loops({contour});
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(area_mm2(loops), signed_area_mm2(circle({0, 0}, 10, 60)) - 16, area_tolerance_mm2);
}

TEST(SimpleLoops, SeveralKeyholesInOneCurve) {
  Contour contour;
  contour.points_mm = {{0, 0},  {20, 0}, {20, 10}, {0, 10}, {0, 5},  {2, 5}, {2, 7}, {6, 7}, {6, 5}, {10, 5},
                       {10, 7}, {14, 7}, {14, 3},  {10, 3}, {10, 5}, {6, 5}, {6, 3}, {2, 3}, {2, 5}, {0, 5}};
  const std::vector<Contour> loops = simple_loops({contour});
  EXPECT_EQ(loops.size(), 3u);
  EXPECT_NEAR(area_mm2(loops), 200 - 16 - 16, 1e-9);
}

TEST(SimpleLoops, WhatOverlapsIsAHoleOrAddsUp) {
  const std::vector<Contour> squares = {rectangle(0, 0, 10, 10), rectangle(5, 5, 15, 15)};
  const std::vector<Contour> odd = simple_loops(squares, InsideRule::odd);
  EXPECT_NEAR(area_mm2(odd), 150, 1e-9);
  EXPECT_FALSE(is_inside(odd, {7, 7}));
  const std::vector<Contour> any = simple_loops(squares, InsideRule::any);
  ASSERT_EQ(any.size(), 1u);
  EXPECT_NEAR(area_mm2(any), 175, 1e-9);
  EXPECT_TRUE(is_inside(any, {7, 7}));
}

TEST(SimpleLoops, TheUnionFillsNestedLoopsAndKeepsKeyholes) {
  const std::vector<Contour> nested =
      simple_loops({rectangle(-20, -20, 20, 20), rectangle(-5, -5, 5, 5)}, InsideRule::any);
  ASSERT_EQ(nested.size(), 1u);
  EXPECT_NEAR(area_mm2(nested), 1600, 1e-9);
  const std::vector<Contour> ring = simple_loops({keyhole(), rectangle(30, 0, 31, 1)}, InsideRule::any);
  EXPECT_EQ(ring.size(), 3u);
  EXPECT_FALSE(is_inside(ring, {0, 0}));
}

TEST(SimpleLoops, SharedBordersVanish) {
  const std::vector<Contour> halves = {rectangle(0, 0, 5, 10), rectangle(5, 2, 10, 8)};
  for (const InsideRule rule : {InsideRule::odd, InsideRule::any}) {
    const std::vector<Contour> loops = simple_loops(halves, rule);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_NEAR(area_mm2(loops), 80, 1e-9);
  }
  EXPECT_TRUE(simple_loops({halves[0], halves[0]}, InsideRule::odd).empty());
  EXPECT_EQ(simple_loops({halves[0], halves[0]}, InsideRule::any).size(), 1u);
}

TEST(SimpleLoops, ABowTieIsTwoLobesAndASpikeVanishes) {
  const std::vector<Contour> lobes = simple_loops({Contour{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, 0}});
  ASSERT_EQ(lobes.size(), 2u);
  for (const Contour& lobe : lobes) {
    EXPECT_EQ(lobe.depth, 0);
    EXPECT_NEAR(signed_area_mm2(lobe), 25, 1e-9);
  }
  const std::vector<Contour> spiked =
      simple_loops({Contour{{{0, 0}, {10, 0}, {10, 10}, {15, 15}, {10, 10}, {0, 10}}, 0}});
  ASSERT_EQ(spiked.size(), 1u);
  EXPECT_EQ(spiked[0].points_mm.size(), 4u);
}

TEST(SimpleLoops, RandomTanglesKeepWhatTheyEnclose) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 50);
  for (int round = 0; round < 20; ++round) {
    std::vector<Contour> tangle(3);
    for (Contour& contour : tangle)
      for (int i = 0; i < 12; ++i) contour.points_mm.push_back({place(random), place(random)});
    for (const InsideRule rule : {InsideRule::odd, InsideRule::any}) {
      const std::vector<Contour> loops = simple_loops(tangle, rule);
      for (const Contour& loop : loops) EXPECT_FALSE(self_crossing(loop));
      int wrong = 0;
      for (int i = 0; i < 500; ++i) {
        const Eigen::Vector2d point(place(random), place(random));
        int count = 0;
        for (const Contour& contour : tangle) count += is_inside({contour}, point) ? 1 : 0;
        const bool expected = rule == InsideRule::odd ? count % 2 == 1 : count > 0;
        if (std::abs(signed_distance_mm(loops, point)) > 0.02 && is_inside(loops, point) != expected) ++wrong;
      }
      EXPECT_EQ(wrong, 0) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace isostack

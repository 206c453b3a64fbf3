#include "recon/subdivision/figure_interpolator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/subdivision/loop_tiling.h"
#include "recon/subdivision/pinched_loops.h"
#include "recon/subdivision/rising_chain.h"
#include "recon/subdivision/simplex_section.h"

namespace isostack {
namespace {

std::vector<Eigen::Vector2d> circle_points(const Eigen::Vector2d& centre, double radius_mm, int count) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(centre + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Contour circle(const Eigen::Vector2d& centre, double radius_mm, int count = 32) {
  return {.points_mm = circle_points(centre, radius_mm, count)};
}

FigureLayer layer(double t_mm, std::vector<Contour> contours, bool topological = false) {
  orient_by_nesting(contours);
  return {.t_mm = t_mm, .contours = std::move(contours), .topological = topological};
}

/// A loop lies between two parts of this figure: a disc whose hole touches its edge at the left.
FigureLayer touching_ring(double t_mm) {
  Contour outer = circle({0, 0}, 20);
  outer.points_mm[16] = {-20, 0};
  Contour hole = circle({-10, 0}, 10);
  hole.points_mm[16] = {-20, 0};
  return layer(t_mm, {outer, hole}, true);
}

/// Every edge between the ends has two triangles that run along it in opposite directions; at the ends it has one.
void expect_surface(const SimplicialMesh& mesh) {
  const double first = mesh.vertices.row(2).minCoeff(), last = mesh.vertices.row(2).maxCoeff();
  std::map<std::pair<int, int>, int> directed;
  for (Eigen::Index s = 0; s < mesh.simplex_count(); ++s)
    for (int i = 0; i < 3; ++i) ++directed[{mesh.simplices(i, s), mesh.simplices((i + 1) % 3, s)}];
  for (const auto& [edge, count] : directed) {
    const double a = mesh.vertices(2, edge.first), b = mesh.vertices(2, edge.second);
    const bool at_end = a == b && (a == first || a == last);
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed.contains({edge.second, edge.first}), !at_end);
  }
}

std::size_t loops_at(const SimplicialMesh& mesh, double t_mm) {
  return section_contours(mesh, values_at_time(mesh, t_mm)).size();
}

TEST(ContourLevels, HaveEveryPointAndLieOnTheContour) {
  Contour contour = circle({3, 4}, 10, 75);
  contour.points_mm[20] = {3, 16};  // a thorn
  const ContourLevels levels = contour_levels(contour, {.levels = 4, .tolerance_mm = 0.5});
  EXPECT_LE(levels.base_count(), 40);
  for (const Eigen::Vector2d& point : contour.points_mm)
    EXPECT_EQ((levels.places_mm.colwise() - point).colwise().norm().minCoeff(), 0);
  for (Eigen::Index i = 0; i < levels.places_mm.cols(); ++i)
    EXPECT_NEAR(signed_distance_mm({contour}, levels.places_mm.col(i)), 0, 1e-12);  // straight sides: rounding
}

TEST(ContourLevels, RoundVerticesThatTurnLessThanTheAngleAndNoOthers) {
  const Contour twelve = circle({0, 0}, 10, 12);  // turns 30 degrees at each corner
  const double midpoint_mm = 10 * std::cos(std::numbers::pi / 12);
  const auto inner_radius = [&](double degrees) {
    const ContourLevels levels =
        contour_levels(twelve, {.levels = 4, .sharp_angle_rad = degrees * std::numbers::pi / 180});
    return levels.places_mm.colwise().norm().minCoeff();
  };
  EXPECT_NEAR(inner_radius(20), midpoint_mm, 1e-9);  // all sharp: the polygon; rounding
  // Round: cubic pieces through the corners with the circle's tangents, too long by what the parabola makes of them.
  EXPECT_GT(inner_radius(40), 10 - 0.1 * (10 - midpoint_mm));
}

TEST(LoopTiling, JoinsLikePlacesOfLikeLoopsThatHaveMoved) {
  const auto lower = circle_points({0, 0}, 10, 9), upper = circle_points({25, -3}, 10, 9);
  const std::vector<LoopPair> edges = tile_loops(lower, upper, {});
  EXPECT_EQ(edges.size(), 18U);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(std::count(edges.begin(), edges.end(), LoopPair(i, i)), 1);
}

TEST(LoopTiling, GoesThroughTheEdgesAskedForAndRefusesThoseThatCross) {
  const auto loop = circle_points({0, 0}, 10, 12);
  const std::vector<LoopPair> edges = tile_loops(loop, loop, {.joined = {{0, 3}, {6, 8}}});
  EXPECT_EQ(edges.size(), 24U);
  EXPECT_EQ(std::count(edges.begin(), edges.end(), LoopPair(0, 3)), 1);
  EXPECT_EQ(std::count(edges.begin(), edges.end(), LoopPair(6, 8)), 1);
  EXPECT_THROW(tile_loops(loop, loop, {.joined = {{0, 0}, {4, 8}, {8, 4}}}), InputError);
}

TEST(PinchedLoops, MakeOneOfTwoAndTwoOfOne) {
  std::vector<Eigen::Vector2d> left = circle_points({-10, 0}, 10, 16), right = circle_points({10, 0}, 10, 16);
  left[0] = right[8] = {0, 0};
  const PinchedLoops loops = pinched_loops({left, right}, 1e-6);
  ASSERT_EQ(loops.pinches.size(), 1U);
  EXPECT_EQ(loops.count({false}), (LoopCount{.outer = 2, .holes = 0}));
  EXPECT_EQ(loops.count({true}), (LoopCount{.outer = 1, .holes = 0}));
  const auto whole = loops.loops({true});
  EXPECT_EQ(whole[0].size(), 32U);
  EXPECT_NEAR(loops.signed_area_mm2(whole[0]), 2 * 16 * 100 * std::sin(std::numbers::pi / 8) / 2, 1e-9);  // rounding
  EXPECT_EQ(switched_for(loops, {.outer = 1, .holes = 0}), std::vector<bool>{true});
}

TEST(FigureInterpolator, SplitsOneIntoTwoHalfWay) {
  const FigureInterpolator figures =
      figure_interpolator({layer(0, {circle({0, 0}, 20)}), layer(20, {circle({-14, 0}, 9), circle({14, 0}, 9)})}, {});
  expect_surface(figures.base);
  EXPECT_EQ(loops_at(figures.base, 9), 1U);
  EXPECT_EQ(loops_at(figures.base, 11), 2U);
}

TEST(FigureInterpolator, ClosesAHoleThatHasNoCounterpart) {
  const FigureInterpolator figures =
      figure_interpolator({layer(0, {circle({0, 0}, 20), circle({3, 0}, 8)}), layer(20, {circle({0, 0}, 18)})}, {});
  expect_surface(figures.base);
  EXPECT_EQ(loops_at(figures.base, 9), 2U);
  EXPECT_EQ(loops_at(figures.base, 11), 1U);
}

TEST(FigureInterpolator, OpensAHoleWhereAKeyShapeTouchesTheEdge) {
  const FigureInterpolator figures = figure_interpolator(
      {layer(0, {circle({0, 0}, 20), circle({0, 0}, 8)}), touching_ring(10), layer(20, {circle({0, 0}, 18)})}, {});
  expect_surface(figures.base);
  EXPECT_EQ(loops_at(figures.base, 9), 2U);
  const std::vector<Contour> opened = section_contours(figures.base, values_at_time(figures.base, 11));
  ASSERT_EQ(opened.size(), 1U);
  EXPECT_FALSE(is_inside(opened, {-10, 0})) << "the hole must be open, not closed";
}

TEST(FigureInterpolator, JoinsFeaturesThroughAProposedKeyShape) {
  FigureInterpolatorOptions options;
  options.features.push_back({{{.layer = 0, .contour = 0, .point = 16}, {.layer = 1, .contour = 0, .point = 16}}});
  const FigureInterpolator figures = figure_interpolator(
      {layer(0, {circle({0, 0}, 20)}), layer(20, {circle({-14, 0}, 9), circle({14, 0}, 9)})}, options);
  const auto vertex_at = [&](const Eigen::Vector3d& place) {
    Eigen::Index nearest = 0;
    EXPECT_NEAR((figures.base.vertices.colwise() - place).colwise().norm().minCoeff(&nearest), 0, 1e-12);  // rounding
    return static_cast<int>(nearest);
  };
  const auto chain = rising_chain(figures.base, vertex_at({-20, 0, 0}), vertex_at({-23, 0, 20}));
  ASSERT_TRUE(chain.has_value());
  EXPECT_EQ(chain->size(), 3U);
  EXPECT_EQ(figures.base.vertices(2, (*chain)[1]), 10);
}

}  // namespace
}  // namespace isostack

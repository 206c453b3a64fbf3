#include "sample_data/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace isostack {
namespace {

/// Area inside, counted on a lattice of 0.25 mm over the picture.
double area_mm2(const PlaneFigure& figure) {
  double area = 0;
  for (double y = 0; y < 96; y += 0.25)
    for (double x = 0; x < 96; x += 0.25) area += figure.distance_mm({x, y}) > 0 ? 0.0625 : 0;
  return area;
}

TEST(Shapes, FiguresFillWhatTheyShouldAndStayInThePicture) {
  std::map<std::string, double> areas;
  for (const PlaneFigure& figure : plane_figures()) {
    areas[figure.name] = area_mm2(figure);
    for (double along = 0; along < 96; ++along)
      for (const Eigen::Vector2d& rim : {Eigen::Vector2d(along, 3.5), {along, 91.5}, {3.5, along}, {91.5, along}})
        EXPECT_LT(figure.distance_mm(rim), 0) << figure.name;
  }
  ASSERT_EQ(areas.size(), 5u);
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(areas["x"], 2 * 82 * 16 - 16 * 16, 25);  // a hundredth: the lattice
  EXPECT_NEAR(areas["o"], pi * (38 * 38 - 20 * 20), 32);
  EXPECT_NEAR(areas["discs"], 2 * pi * 17 * 17, 18);
  EXPECT_NEAR(areas["star"], 10 * 0.5 * 41 * 18 * std::sin(pi / 5), 22);
  EXPECT_GT(areas["bone"], 14 * 60);
}

TEST(Shapes, FiguresAreDistanceLikeAtTheirEdges) {
  for (const PlaneFigure& figure : plane_figures())
    for (double y = 5; y < 90; y += 0.7)
      for (double x = 5; x < 90; x += 0.7) {
        const double here = figure.distance_mm({x, y});
        if (std::abs(here) > 1) continue;
        // A distance changes by no more than the step; both ways at once by no less than some of it.
        const double dx = figure.distance_mm({x + 0.01, y}) - here, dy = figure.distance_mm({x, y + 0.01}) - here;
        EXPECT_LE(std::hypot(dx, dy), 0.01 * 1.5) << figure.name << ' ' << x << ' ' << y;
      }
}

TEST(Shapes, BodiesAreWhereTheirFormulasSay) {
  std::map<std::string, Body> by_name;
  for (const Body& body : bodies()) {
    by_name.emplace(body.name, body);
    for (const int sign : {-1, 1})
      for (int axis = 0; axis < 3; ++axis) EXPECT_LT(body.depth_mm(55 * sign * Eigen::Vector3d::Unit(axis)), 0);
  }
  ASSERT_EQ(by_name.size(), 4u);
  EXPECT_NEAR(by_name.at("sphere").depth_mm({0, 12, 0}), 18, 1e-12);
  EXPECT_NEAR(by_name.at("torus").depth_mm({28, 0, 11}), 0, 1e-12);
  EXPECT_LT(by_name.at("torus").depth_mm({0, 0, 0}), 0);
  EXPECT_NEAR(by_name.at("knot").depth_mm({0, -12.4, 0}), 7, 0.05);  // the curve at angle 0: chords of 2 mm
  const Eigen::Vector3d tip = Eigen::Vector3d(1, std::numbers::phi, 0).normalized();
  EXPECT_GT(by_name.at("star").depth_mm(43 * tip), 0);
  EXPECT_LT(by_name.at("star").depth_mm(43 * Eigen::Vector3d(1, 1, 1).normalized()), 0);
}

}  // namespace
}  // namespace isostack

#include "sample_data/outlines.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace isostack {

namespace {

using Points = std::vector<Eigen::Vector2d>;

struct Arc {
  Eigen::Vector2d centre_mm;
  double radius_mm = 0;
  double from_degrees = 0, to_degrees = 0;  ///< from x to y; both ends belong to it
};

void append(Points& points, const Arc& arc) {
  constexpr double step_degrees = 15;
  const int steps = static_cast<int>(std::ceil(std::abs(arc.to_degrees - arc.from_degrees) / step_degrees - 1e-9));
  for (int i = 0; i <= steps; ++i) {
    const double angle = (arc.from_degrees + (arc.to_degrees - arc.from_degrees) * i / steps) * std::numbers::pi / 180;
    points.emplace_back(arc.centre_mm + arc.radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
}

Points ring(const Eigen::Vector2d& centre_mm, const Eigen::Vector2d& radii_mm) {
  Points points;
  append(points, {.centre_mm = {0, 0}, .radius_mm = 1, .from_degrees = 0, .to_degrees = 345});
  for (Eigen::Vector2d& point : points) point = centre_mm + radii_mm.cwiseProduct(point);
  return points;
}

/// Two discs in one.
Points eight() {
  constexpr double meet_degrees = 57.3, meet_below_degrees = 60.6;
  Points points;
  append(points, {{48, 30}, 20, 180 - meet_degrees, 180});
  points.pop_back();
  append(points, {{48, 30}, 20, 180, 360 + meet_degrees});
  points.pop_back();
  append(points, {{48, 66}, 22, -meet_below_degrees, 180});
  points.pop_back();
  append(points, {{48, 66}, 22, 180, 180 + meet_below_degrees});
  points.pop_back();
  return points;
}

Points two() {
  Points points;
  append(points, {{48, 34}, 24, 180, 390});
  points.insert(points.end(), {{44, 76}, {72, 76}, {72, 88}, {24, 88}, {24, 78}});
  append(points, {{48, 34}, 12, 390, 180});
  return points;
}

Points three() {
  constexpr double meet_degrees = 58.2;
  Points points;
  append(points, {{46, 31}, 20, 205, 360 + meet_degrees});
  Points below;
  append(below, {{46, 65}, 20, -meet_degrees, 155});
  points.insert(points.end(), below.begin() + 1, below.end());
  append(points, {{46, 65}, 9, 155, -90});
  points.insert(points.end(), {{36, 54}, {36, 42}});
  append(points, {{46, 31}, 9, 90, -155});
  return points;
}

Points pointed_star() {
  Points points;
  for (int i = 0; i < 10; ++i) {
    const double angle = (36.0 * i - 90) * std::numbers::pi / 180, radius_mm = i % 2 == 0 ? 40 : 17;
    points.emplace_back(48 + radius_mm * std::cos(angle), 50 + radius_mm * std::sin(angle));
  }
  return points;
}

Points fan() {
  Points points = {{48, 86}};
  append(points, {{48, 60}, 44, 200, 340});
  return points;
}

ContourSlice figure(std::string name, const std::vector<Points>& loops) {
  ContourSlice slice{.name = std::move(name), .pose = {}, .size_pixels = {96, 96}, .contours = {}};
  for (const Points& loop : loops) slice.contours.push_back({.points_mm = loop});
  orient_by_nesting(slice.contours);
  return slice;
}

}  // namespace

std::vector<ContourSlice> outline_figures() {
  return {figure("one", {{{34, 24}, {46, 12}, {56, 12}, {56, 86}, {42, 86}, {42, 32}, {34, 36}}}),
          figure("two", {two()}),
          figure("three", {three()}),
          figure("seven", {{{26, 12}, {72, 12}, {72, 24}, {50, 86}, {36, 86}, {57, 26}, {26, 26}}}),
          figure("eight", {eight(), ring({48, 30}, {10, 10}), ring({48, 66}, {12, 12})}),
          figure("eight_to_seven", {eight(), ring({43, 30}, {15, 10}), ring({42, 66}, {16, 12})}),
          figure("pointed", {pointed_star()}),
          figure("triangle", {{{48, 12}, {84, 78}, {12, 78}}}),
          figure("fan", {fan()})};
}

}  // namespace isostack

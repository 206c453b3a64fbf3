#include "recon/subdivision/directed_loops.h"

#include <Eigen/Geometry>
#include <cstddef>

#include "recon/geometry/self_crossing.h"
#include "recon/geometry/simple_loops.h"

namespace isostack {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::AlignedBox2d box_of(const Contour& contour) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box;
}

bool any_crosses(const std::vector<Contour>& loops) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (self_crossing(loops[i])) return true;
    for (std::size_t j = 0; j < i; ++j)
      if (cross_each_other(loops[i], loops[j])) return true;
  }
  return false;
}

/// Within the loop beside the middle of its longest side.
Eigen::Vector2d inner_point(const Contour& contour) {
  constexpr double share = 1e-4;  // of the side
  const auto& points = contour.points_mm;
  Eigen::Vector2d place = points[0], longest(0, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d side = points[(i + 1) % points.size()] - points[i];
    if (side.squaredNorm() <= longest.squaredNorm()) continue;
    longest = side;
    place = points[i] + side / 2;
  }
  const double left = signed_area_mm2(contour) > 0 ? share : -share;
  return place + left * Eigen::Vector2d(-longest.y(), longest.x());
}

/// How often the loops run round the place, counter-clockwise.
int turns_round(const std::vector<Contour>& loops, const Eigen::Vector2d& place) {
  int turns = 0;
  for (const Contour& loop : loops)
    for (std::size_t i = 0; i < loop.points_mm.size(); ++i) {
      const Eigen::Vector2d &a = loop.points_mm[i], &b = loop.points_mm[(i + 1) % loop.points_mm.size()];
      if ((a.y() <= place.y()) == (b.y() <= place.y())) continue;
      const double side = cross(b - a, place - a);
      if (b.y() > a.y() && side > 0) ++turns;
      if (b.y() < a.y() && side < 0) --turns;
    }
  return turns;
}

/// What outer loops have and holes have, without islands in these, each as one; then what only one of the two has.
std::vector<Contour> cut(const std::vector<Contour>& directed) {
  std::vector<Contour> outer, holes, islands;
  for (const Contour& loop : directed)
    if (signed_area_mm2(loop) < 0) holes.push_back(loop);
  for (const Contour& loop : directed)
    if (signed_area_mm2(loop) > 0) (is_inside(holes, inner_point(loop)) ? islands : outer).push_back(loop);
  std::vector<Contour> both = simple_loops(outer, InsideRule::any);
  holes = simple_loops(holes, InsideRule::any);
  both.insert(both.end(), holes.begin(), holes.end());
  both = simple_loops(both, InsideRule::odd);
  both.insert(both.end(), islands.begin(), islands.end());
  return both;
}

}  // namespace

bool cross_each_other(const Contour& one, const Contour& other) {
  const Eigen::AlignedBox2d shared = box_of(one).intersection(box_of(other));
  if (shared.isEmpty()) return false;
  const auto differ = [](double u, double v, double rounding) {
    return (u > rounding && v < -rounding) || (u < -rounding && v > rounding);
  };
  for (std::size_t i = 0; i < one.points_mm.size(); ++i) {
    const Eigen::Vector2d &a = one.points_mm[i], &b = one.points_mm[(i + 1) % one.points_mm.size()];
    if (!shared.intersects(Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b)))) continue;
    for (std::size_t j = 0; j < other.points_mm.size(); ++j) {
      const Eigen::Vector2d &c = other.points_mm[j], &d = other.points_mm[(j + 1) % other.points_mm.size()];
      const double rounding = 1e-9 * (b - a).norm() * (d - c).norm();
      if (differ(cross(b - a, c - a), cross(b - a, d - a), rounding) &&
          differ(cross(d - c, a - c), cross(d - c, b - c), rounding))
        return true;
    }
  }
  return false;
}

std::vector<Contour> figure_of(std::vector<Contour> directed) {
  std::vector<Contour> loops = any_crosses(directed) ? cut(directed) : directed;
  orient_by_nesting(loops);
  std::erase_if(loops, [&](const Contour& loop) {
    return (loop.depth % 2 == 0) != (turns_round(directed, inner_point(loop)) >= 1);
  });
  orient_by_nesting(loops);
  return loops;
}

}  // namespace isostack

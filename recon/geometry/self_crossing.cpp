#include "recon/geometry/self_crossing.h"

#include <algorithm>
#include <vector>

namespace isostack {

namespace {

struct Edge {
  Eigen::Vector2d from, to;
  double least_x() const { return std::min(from.x(), to.x()); }
  double largest_x() const { return std::max(from.x(), to.x()); }
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

std::optional<Eigen::Vector2d> crossing(const Edge& a, const Edge& b) {
  const Eigen::Vector2d along = a.to - a.from, other = b.to - b.from;
  const double b_from = cross(along, b.from - a.from), b_to = cross(along, b.to - a.from);
  const double a_from = cross(other, a.from - b.from), a_to = cross(other, a.to - b.from);
  // Rounding must not turn a touch into a crossing.
  const double rounding = 1e-9 * along.norm() * other.norm();
  const auto differ = [&](double u, double v) {
    return (u > rounding && v < -rounding) || (u < -rounding && v > rounding);
  };
  if (!differ(b_from, b_to) || !differ(a_from, a_to)) return std::nullopt;
  return a.from + along * (a_from / (a_from - a_to));
}

}  // namespace

std::optional<Eigen::Vector2d> self_crossing(const Contour& contour) {
  const auto& points = contour.points_mm;
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) edges.push_back({points[i], points[(i + 1) % points.size()]});
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.least_x() < b.least_x(); });
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].least_x() <= edges[i].largest_x(); ++j)
      if (auto point = crossing(edges[i], edges[j])) return point;
  return std::nullopt;
}

}  // namespace isostack

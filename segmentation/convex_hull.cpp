#include "segmentation/convex_hull.h"

#include <algorithm>
#include <cmath>

#include "recon/geometry/contour.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Raises phi to the distance from the convex curve, within and a few pixels around its bounding box.
void add_convex(const Contour& hull, const Eigen::Vector2d& spacing_mm, Image<float>& phi) {
  Eigen::Vector2d low = hull.points_mm.front(), high = low;
  for (const Eigen::Vector2d& point : hull.points_mm) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  constexpr double margin = 3;  // pixels
  const auto first = [&](int axis) { return std::max(0.0, std::floor(low[axis] / spacing_mm[axis] - margin)); };
  const auto last = [&](int axis, Eigen::Index count) {
    return std::min(static_cast<double>(count - 1), std::ceil(high[axis] / spacing_mm[axis] + margin));
  };
  for (auto row = static_cast<Eigen::Index>(first(1)); row <= static_cast<Eigen::Index>(last(1, phi.rows())); ++row)
    for (auto column = static_cast<Eigen::Index>(first(0)); column <= static_cast<Eigen::Index>(last(0, phi.cols()));
         ++column) {
      const Eigen::Vector2d at = Eigen::Vector2d(column, row).cwiseProduct(spacing_mm);
      phi(row, column) = std::max(phi(row, column), static_cast<float>(signed_distance_mm({hull}, at)));
    }
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;  // Andrew's monotone chain
  const auto build = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], *it - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  build(points.begin(), points.end());
  build(points.rbegin(), points.rend());
  return hull;
}

Image<float> hull_of_parts(const Image<float>& phi, const Eigen::Vector2d& spacing_mm) {
  const double far_mm = 3 * spacing_mm.maxCoeff();
  Image<float> result = Image<float>::Constant(phi.rows(), phi.cols(), static_cast<float>(-far_mm));
  for (const Contour& contour : trace_contours(phi, spacing_mm)) {
    if (contour.depth != 0) continue;
    Contour hull{convex_hull(contour.points_mm), 0};
    if (hull.points_mm.size() >= 3) add_convex(hull, spacing_mm, result);
  }
  return result;
}

}  // namespace isostack

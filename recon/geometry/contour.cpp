#include "recon/geometry/contour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isostack {

namespace {

/// Calls visit(a, b) for each edge of the closed curve.
template <class Visit>
void for_each_edge(const Contour& contour, Visit visit) {
  const auto& points = contour.points_mm;
  for (std::size_t i = 0, previous = points.size() - 1; i < points.size(); previous = i++)
    visit(points[previous], points[i]);
}

double squared_distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (a + t * ab - p).squaredNorm();
}

bool holds(const Contour& contour, const Eigen::Vector2d& p) {
  bool inside = false;
  for_each_edge(contour, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    if ((a.y() > p.y()) == (b.y() > p.y())) return;
    const double crossing_x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (p.x() < crossing_x) inside = !inside;
  });
  return inside;
}

double squared_distance(const Contour& contour, const Eigen::Vector2d& p) {
  double nearest2 = std::numeric_limits<double>::infinity();
  for_each_edge(contour, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    nearest2 = std::min(nearest2, squared_distance_to_segment(p, a, b));
  });
  return nearest2;
}

Eigen::AlignedBox2d box_of(const Contour& contour) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box;
}

/// Where the curves touch, rounding decides on which side a point is: a point clear of the other curve tells.
bool lies_within(const Contour& inner, const Eigen::AlignedBox2d& inner_box, const Contour& outer,
                 const Eigen::AlignedBox2d& outer_box) {
  const double size_mm = inner_box.diagonal().norm(), clear_mm = 1e-3 * size_mm, nothing_mm = 1e-9 * size_mm;
  if ((inner_box.min().array() < outer_box.min().array() - clear_mm).any() ||
      (inner_box.max().array() > outer_box.max().array() + clear_mm).any())
    return false;
  double farthest_mm = 0;
  bool result = false;
  const auto is_clear = [&](const Eigen::Vector2d& point) {
    const double distance_mm = std::sqrt(squared_distance(outer, point));
    if (distance_mm <= farthest_mm) return false;
    farthest_mm = distance_mm;
    result = holds(outer, point);
    return distance_mm > clear_mm;
  };
  for (const Eigen::Vector2d& point : inner.points_mm)
    if (is_clear(point)) return result;
  bool is_settled = false;
  for_each_edge(inner, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    is_settled = is_settled || is_clear((a + b) / 2);
  });
  return farthest_mm > nothing_mm && result;
}

}  // namespace

double signed_area_mm2(const Contour& contour) {
  double twice_area = 0;
  for_each_edge(contour, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    twice_area += a.x() * b.y() - a.y() * b.x();
  });
  return twice_area / 2;
}

double perimeter_mm(const Contour& contour) {
  double length = 0;
  for_each_edge(contour, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { length += (b - a).norm(); });
  return length;
}

bool is_inside(const std::vector<Contour>& contours, const Eigen::Vector2d& point_in_slice_mm) {
  bool inside = false;
  for (const Contour& contour : contours)
    if (holds(contour, point_in_slice_mm)) inside = !inside;
  return inside;
}

double signed_distance_mm(const std::vector<Contour>& contours, const Eigen::Vector2d& point_in_slice_mm) {
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const Contour& contour : contours) nearest2 = std::min(nearest2, squared_distance(contour, point_in_slice_mm));
  const double distance = std::sqrt(nearest2);
  return is_inside(contours, point_in_slice_mm) ? distance : -distance;
}

bool encloses(const Contour& outer, const Contour& inner) {
  return lies_within(inner, box_of(inner), outer, box_of(outer));
}

void orient_by_nesting(std::vector<Contour>& contours) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const Contour& contour : contours) boxes.push_back(box_of(contour));
  for (std::size_t i = 0; i < contours.size(); ++i) {
    int depth = 0;
    for (std::size_t j = 0; j < contours.size(); ++j)
      if (j != i && lies_within(contours[i], boxes[i], contours[j], boxes[j])) ++depth;
    contours[i].depth = depth;
    const bool is_outer = depth % 2 == 0;
    if ((signed_area_mm2(contours[i]) > 0) != is_outer)
      std::reverse(contours[i].points_mm.begin(), contours[i].points_mm.end());
  }
}

std::size_t point_count(const ContourStack& stack) {
  std::size_t count = 0;
  for (const ContourSlice& slice : stack.slices)
    for (const Contour& contour : slice.contours) count += contour.points_mm.size();
  return count;
}

}  // namespace isostack

#include "recon/constraints/plane_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostack {

std::optional<PlaneLine> line_between(const SlicePose& a, const SlicePose& b) {
  if (are_parallel(a, b)) return std::nullopt;
  const Eigen::Vector3d na = a.normal(), nb = b.normal(), across = na.cross(nb);
  // From a's origin within plane a towards plane b: places along the line stay small and well conditioned.
  const Eigen::Vector3d towards_b = across.cross(na).normalized();
  const double step_mm = (b.origin_mm - a.origin_mm).dot(nb) / towards_b.dot(nb);
  return PlaneLine{a.origin_mm + step_mm * towards_b, across.normalized()};
}

Eigen::AlignedBox2d around_contours(const SlicePose& pose, const Eigen::AlignedBox3d& contours_box) {
  Eigen::AlignedBox2d region;
  for (int corner = 0; corner < 8; ++corner)
    region.extend(pose.world_to_slice(contours_box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  const Eigen::Vector2d margin = 0.1 * region.sizes();
  return {region.min() - margin, region.max() + margin};
}

Eigen::AlignedBox2d field_of_view(const ContourSlice& slice, const Eigen::AlignedBox3d& contours_box) {
  if ((slice.size_pixels.array() <= 0).any()) return around_contours(slice.pose, contours_box);
  return {Eigen::Vector2d::Zero(), slice.pose.pixel_to_slice((slice.size_pixels.array() - 1).cast<double>().matrix())};
}

LineRange range_within(const PlaneLine& line, const SlicePose& pose, const Eigen::AlignedBox2d& region) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d start = pose.world_to_slice(line.origin_mm);
  const Eigen::Vector2d direction = pose.world_to_slice(line.at(1)) - start;
  LineRange range{-infinity, infinity};
  for (int axis = 0; axis < 2; ++axis) {
    double low = region.min()[axis] - start[axis], high = region.max()[axis] - start[axis];
    if (std::abs(direction[axis]) < 1e-12) {
      if (low > 0 || high < 0) return {infinity, -infinity};
      continue;
    }
    low /= direction[axis], high /= direction[axis];
    range.first_mm = std::max(range.first_mm, std::min(low, high));
    range.last_mm = std::min(range.last_mm, std::max(low, high));
  }
  return range;
}

std::vector<ContourCrossing> crossings_along(const PlaneLine& line, const ContourSlice& slice) {
  const Eigen::Vector2d start = slice.pose.world_to_slice(line.origin_mm);
  const Eigen::Vector2d along = (slice.pose.world_to_slice(line.at(1)) - start).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  std::vector<ContourCrossing> crossings;
  for (const Contour& contour : slice.contours) {
    const auto& points = contour.points_mm;
    for (std::size_t i = 0, previous = points.size() - 1; i < points.size(); previous = i++) {
      const Eigen::Vector2d a = points[previous] - start, b = points[i] - start;
      const double side_a = across.dot(a), side_b = across.dot(b);
      if ((side_a > 0) == (side_b > 0)) continue;
      const double t = side_a / (side_a - side_b);
      const Eigen::Vector2d edge = (b - a).normalized();
      const Eigen::Vector3d inward = -edge.y() * slice.pose.x_axis + edge.x() * slice.pose.y_axis;
      crossings.push_back({along.dot(a + t * (b - a)), inward});
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.place_mm < b.place_mm; });
  return crossings;
}

Eigen::AlignedBox3d box_of_contours(const ContourStack& stack) {
  Eigen::AlignedBox3d box;
  for (const ContourSlice& slice : stack.slices)
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& p : contour.points_mm) box.extend(slice.pose.slice_to_world(p));
  return box;
}

}  // namespace isostack
